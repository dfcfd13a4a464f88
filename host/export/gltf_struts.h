#pragma once
#include <tiny_gltf.h>

#include <Eigen/Core>

#include "grid/joint_rotations.h"
#include "grid/strut_grid.h"

namespace morphgrid {

/// Up to as many struts are drawn as solids; more are lines, which take a tenth of the bytes.
constexpr int kMostSolidStruts = 50'000;

/// How the struts of a grid are drawn. Solids show their colours in every viewer, while some draw
/// all lines in one colour.
enum class StrutShape {
  lines,
  tubes,  ///< tubeVertices(), of springs.
  bars,   ///< barVertices(), of frames.
};
StrutShape strutShapeOf(const StrutGrid& grid);

/// The vertices of every strut, in the order of forEachStrut(); of lines both ends. Every strut has
/// vertices of its own, since shared ones would blend the colours of neighbours. rotations: of a
/// frame's joints.
Eigen::Matrix3Xd strutVertices(const StrutGrid& grid, const Eigen::Matrix3Xd& positions,
                               const JointRotations& rotations);

/// In the colours of the struts' strain. Solids have no normals: then the standard wants their
/// sides flat.
tinygltf::Primitive addStruts(tinygltf::Model& model, const StrutGrid& grid,
                              const Eigen::Matrix3Xd& positions, const JointRotations& rotations);

/// A mesh of one primitive in a node of its own.
void addStrutNode(tinygltf::Model& model, tinygltf::Primitive struts);

}  // namespace morphgrid
