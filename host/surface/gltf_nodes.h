#pragma once
#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "surface/gltf_model.h"

namespace morphgrid {

/// Where a file's nodes are.
struct GltfNodes {
  /// Nothing for nodes in a circle that no scene shows.
  std::vector<std::optional<Eigen::Affine3d>> worldFromNode;
  std::vector<int> shown;  ///< Those of the scene that are visible, with what they hold.
};

/// Walks the scene, or all nodes where there is none; then what it leaves out, for joints may lie
/// elsewhere. A node is hidden by itself or one above it (KHR_node_visibility). Throws InputError
/// when a node does not exist, has two parents or a transform of too few numbers.
GltfNodes placeNodes(const GltfModel& model);

}  // namespace morphgrid
