#pragma once
#include "surface/gltf_nodes.h"
#include "surface/gltf_values.h"

namespace morphgrid {

/// A mesh as a node shows it.
struct GltfInstance {
  Eigen::Affine3d worldFromNode;
  /// World from mesh, for each joint; empty: no skin, worldFromNode places the mesh.
  std::vector<Eigen::Affine3d> worldFromMesh;
  std::vector<double> morphWeights;  ///< Of the mesh's targets; those that are missing are 0.
};

GltfInstance instanceOf(GltfValues& values, const GltfNodes& nodes, int node);

/// What a primitive's vertices are made from: those of equal sources are the same.
std::vector<int> vertexSources(const tinygltf::Primitive& primitive);

/// A primitive's vertices in the world, 3 x n: morphed, then moved by the node or, where it has a
/// skin and they have joints, by these. Throws InputError.
Eigen::Matrix3Xd readVertices(GltfValues& values, const tinygltf::Primitive& primitive,
                              const GltfInstance& instance);

}  // namespace morphgrid
