#pragma once
#include <tiny_gltf.h>

#include <Eigen/Core>
#include <filesystem>
#include <string>

#include "grid/joint_rotations.h"
#include "grid/strut_grid.h"

namespace morphgrid {

/// Parts of which the glTF files are put together. Numbers go to the model's one buffer; accessors
/// are given by their index.

/// One scene, without nodes yet.
tinygltf::Model emptyModel();

int addScalars(tinygltf::Model& model, const Eigen::VectorXf& scalars);
int addVectors(tinygltf::Model& model, const Eigen::Matrix3Xf& vectors);
int addIndices(tinygltf::Model& model, const Eigen::Matrix3Xi& triangles);

/// With the bounds that the standard wants of positions and of times.
int addPositions(tinygltf::Model& model, const Eigen::Matrix3Xf& positions);
int addTimes(tinygltf::Model& model, const Eigen::VectorXf& seconds);

/// Both ends of every strut, in the order of forEachStrut(): every strut has vertices of its own,
/// since shared ones would blend the colours of neighbours. Of a frame the vertices of
/// barVertices(); rotations: of its joints.
Eigen::Matrix3Xf strutVertices(const StrutGrid& grid, const Eigen::Matrix3Xd& positions,
                               const JointRotations& rotations);

/// Lines, or the bars of a frame, in the colours of the struts' strain. Bars have no normals: then
/// the standard wants their sides flat.
tinygltf::Primitive addStruts(tinygltf::Model& model, const StrutGrid& grid,
                              const Eigen::Matrix3Xd& positions, const JointRotations& rotations);

/// A mesh of one primitive in a node that turns the scene's +z into glTF's up.
void addStrutNode(tinygltf::Model& model, tinygltf::Primitive struts);
void addSurfaceNode(tinygltf::Model& model, tinygltf::Primitive triangles);

/// Throws InputError naming the path when a number does not fit a float.
void requireFloats(const std::filesystem::path& path, const Eigen::Matrix3Xd& values);

/// Throws InputError naming the path when the file would be beyond glTF's size, or the disk
/// refuses.
void writeModel(const std::filesystem::path& path, tinygltf::Model& model);

}  // namespace morphgrid
