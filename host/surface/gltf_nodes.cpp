#include "surface/gltf_nodes.h"

#include <fmt/format.h>

#include <algorithm>

namespace morphgrid {
namespace {

using Transform = Eigen::Affine3d;

template <int size>
Eigen::Vector<double, size> vectorOf(const MeshSource& source, const std::vector<double>& values,
                                     const Eigen::Vector<double, size>& byDefault) {
  if (values.empty()) return byDefault;
  if (values.size() == size) return Eigen::Vector<double, size>::Map(values.data());
  throw source.error(
      fmt::format("a node's transform needs {} numbers, got {}", size, values.size()));
}

Transform parentFromNode(const MeshSource& source, const tinygltf::Node& node) {
  if (!node.matrix.empty()) {
    const auto matrix = vectorOf<16>(source, node.matrix, Eigen::Vector<double, 16>::Zero());
    return Transform(Eigen::Matrix4d::Map(matrix.data()));
  }
  const Eigen::Vector4d rotation = vectorOf<4>(source, node.rotation, {0, 0, 0, 1});
  const Eigen::Vector3d scale = vectorOf<3>(source, node.scale, {1, 1, 1});
  const Eigen::Vector3d translation = vectorOf<3>(source, node.translation, {0, 0, 0});
  return Eigen::Translation3d(translation) * Eigen::Quaterniond(rotation.normalized()) *
         Eigen::Scaling(scale);
}

bool isVisible(const tinygltf::Node& node) {
  const auto extension = node.extensions.find("KHR_node_visibility");
  if (extension == node.extensions.end() || !extension->second.Has("visible")) return true;
  const tinygltf::Value& visible = extension->second.Get("visible");
  return !visible.IsBool() || visible.Get<bool>();
}

class NodeWalk {
 public:
  explicit NodeWalk(const GltfModel& model) : model_(model) {
    nodes_.worldFromNode.resize(model.items.nodes.size());
  }

  GltfNodes place() {
    const std::vector<int> tops = nodesWithoutParent();
    const auto& scenes = model_.items.scenes;
    const int scene = std::max(model_.items.defaultScene, 0);
    walk(scenes.empty() ? tops : itemAt(model_.source, scenes, scene, "scene").nodes);
    const std::size_t shown = nodes_.shown.size();
    for (const int top : tops) {
      if (!nodes_.worldFromNode[top]) walk({top});
    }
    nodes_.shown.resize(shown);
    return std::move(nodes_);
  }

 private:
  struct Visit {
    int node;
    Transform worldFromParent;
    bool isVisible;
  };

  /// A node that comes up twice is its own ancestor or has two parents: neither is allowed, and the
  /// walk might not end.
  void walk(const std::vector<int>& roots) {
    std::vector<Visit> left;
    for (const int root : roots) left.push_back({root, Transform::Identity(), true});
    while (!left.empty()) {
      const Visit visit = left.back();
      left.pop_back();
      const tinygltf::Node& node = itemAt(model_.source, model_.items.nodes, visit.node, "node");
      auto& worldFromNode = nodes_.worldFromNode[visit.node];
      if (worldFromNode) {
        throw model_.source.error(fmt::format("node {} has two parents", visit.node));
      }
      worldFromNode = visit.worldFromParent * parentFromNode(model_.source, node);
      const bool visible = visit.isVisible && isVisible(node);
      if (visible) nodes_.shown.push_back(visit.node);
      for (const int child : node.children) left.push_back({child, *worldFromNode, visible});
    }
  }

  std::vector<int> nodesWithoutParent() const {
    const auto& nodes = model_.items.nodes;
    std::vector<bool> hasParent(nodes.size());
    for (const tinygltf::Node& node : nodes) {
      for (const int child : node.children) {
        itemAt(model_.source, nodes, child, "node");
        hasParent[child] = true;
      }
    }
    std::vector<int> result;
    for (std::size_t i = 0; i < hasParent.size(); ++i) {
      if (!hasParent[i]) result.push_back(static_cast<int>(i));
    }
    return result;
  }

  const GltfModel& model_;
  GltfNodes nodes_;
};

}  // namespace

GltfNodes placeNodes(const GltfModel& model) { return NodeWalk(model).place(); }

}  // namespace morphgrid
