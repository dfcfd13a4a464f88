#include "surface/gltf_vertices.h"

#include <fmt/format.h>

#include <map>
#include <string>

namespace morphgrid {
namespace {

using Transform = Eigen::Affine3d;
using Attributes = std::map<std::string, int>;

/// The accessor of an attribute; below 0: none.
int accessorOf(const Attributes& attributes, const std::string& name) {
  const auto found = attributes.find(name);
  return found == attributes.end() ? -1 : found->second;
}

/// Of each joint; the meshes of a skin lie where its joints take them, not their node.
std::vector<Transform> poseJoints(GltfValues& values, const GltfNodes& nodes, int index) {
  const MeshSource& source = values.model().source;
  const tinygltf::Skin& skin = itemAt(source, values.model().items.skins, index, "skin");
  values.requireRoom(16 * skin.joints.size());
  std::vector<double> inverseBinds;
  if (skin.inverseBindMatrices >= 0) {
    inverseBinds = values.read(skin.inverseBindMatrices, kGltfMatrices);
    if (inverseBinds.size() < 16 * skin.joints.size()) {
      throw source.error(fmt::format("skin {}: {} joints, {} inverse bind matrices", index,
                                     skin.joints.size(), inverseBinds.size() / 16));
    }
  }
  std::vector<Transform> worldFromMesh;
  for (std::size_t i = 0; i < skin.joints.size(); ++i) {
    const auto& worldFromJoint = itemAt(source, nodes.worldFromNode, skin.joints[i], "node");
    if (!worldFromJoint) {
      throw source.error(fmt::format("skin {}: its joint {} hangs from itself", index, i));
    }
    worldFromMesh.push_back(*worldFromJoint);
    if (inverseBinds.empty()) continue;
    worldFromMesh.back() =
        worldFromMesh.back() * Transform(Eigen::Matrix4d::Map(inverseBinds.data() + 16 * i));
  }
  return worldFromMesh;
}

void addTargets(GltfValues& values, const tinygltf::Primitive& primitive,
                const std::vector<double>& weights, std::vector<double>& positions) {
  for (std::size_t i = 0; i < std::min(weights.size(), primitive.targets.size()); ++i) {
    const int accessor = accessorOf(primitive.targets[i], "POSITION");
    if (weights[i] == 0 || accessor < 0) continue;
    const std::vector<double> steps = values.read(accessor, kGltfPositions);
    if (steps.size() != positions.size()) {
      throw values.model().source.error(
          fmt::format("accessor {}: a morph target of {} vertices, the primitive has {}", accessor,
                      steps.size() / 3, positions.size() / 3));
    }
    Eigen::VectorXd::Map(positions.data(), positions.size()) +=
        weights[i] * Eigen::VectorXd::Map(steps.data(), steps.size());
  }
}

/// Moves vertices by their joints, four in each set of attributes, which weigh 1 together.
class Skinning {
 public:
  Skinning(GltfValues& values, const std::vector<Transform>& worldFromMesh, Eigen::Index count)
      : values_(values),
        worldFromMesh_(worldFromMesh),
        sums_(Eigen::Matrix<double, 12, Eigen::Dynamic>::Zero(12, count)),
        weights_(Eigen::VectorXd::Zero(count)) {}

  void addSet(int jointAccessor, int weightAccessor) {
    const std::vector<double> joints = values_.read(jointAccessor, kGltfJoints);
    const std::vector<double> weights = values_.read(weightAccessor, kGltfWeights);
    const auto wanted = static_cast<std::size_t>(4 * weights_.size());
    if (joints.size() < wanted || weights.size() < wanted) {
      throw values_.model().source.error(fmt::format(
          "accessor {}: joints and weights must be as many as the {} vertices, got {} and {}",
          jointAccessor, weights_.size(), joints.size() / 4, weights.size() / 4));
    }
    for (std::size_t i = 0; i < wanted; ++i) {
      if (weights[i] == 0) continue;
      const Transform& joint =
          itemAt(values_.model().source, worldFromMesh_, static_cast<int>(joints[i]), "joint");
      const auto vertex = static_cast<Eigen::Index>(i / 4);
      sums_.col(vertex) += weights[i] * joint.affine().reshaped();
      weights_[vertex] += weights[i];
    }
  }

  /// Vertices without weights follow the first joint.
  void move(Eigen::Ref<Eigen::Matrix3Xd> vertices) const {
    for (Eigen::Index i = 0; i < vertices.cols(); ++i) {
      const bool isHeld = weights_[i] != 0;
      const Eigen::Matrix<double, 3, 4> worldFromMesh =
          isHeld ? Eigen::Matrix<double, 3, 4>(sums_.col(i).reshaped(3, 4) / weights_[i])
                 : Eigen::Matrix<double, 3, 4>(worldFromMesh_.front().affine());
      vertices.col(i) = worldFromMesh * Eigen::Vector3d(vertices.col(i)).homogeneous();
    }
  }

 private:
  GltfValues& values_;
  const std::vector<Transform>& worldFromMesh_;
  Eigen::Matrix<double, 12, Eigen::Dynamic> sums_;
  Eigen::VectorXd weights_;
};

}  // namespace

GltfInstance instanceOf(GltfValues& values, const GltfNodes& nodes, int index) {
  const GltfModel& model = values.model();
  const tinygltf::Node& node = model.items.nodes[index];
  GltfInstance instance{*nodes.worldFromNode[index], {}, node.weights};
  if (node.skin >= 0) instance.worldFromMesh = poseJoints(values, nodes, node.skin);
  if (instance.morphWeights.empty()) {
    instance.morphWeights = itemAt(model.source, model.items.meshes, node.mesh, "mesh").weights;
  }
  return instance;
}

std::vector<int> vertexSources(const tinygltf::Primitive& primitive) {
  std::vector<int> sources = {accessorOf(primitive.attributes, "POSITION")};
  for (const Attributes& target : primitive.targets) {
    sources.push_back(accessorOf(target, "POSITION"));
  }
  for (const auto& [name, accessor] : primitive.attributes) {
    if (name.starts_with("JOINTS_") || name.starts_with("WEIGHTS_")) sources.push_back(accessor);
  }
  return sources;
}

Eigen::Matrix3Xd readVertices(GltfValues& values, const tinygltf::Primitive& primitive,
                              const GltfInstance& instance) {
  std::vector<double> positions =
      values.read(accessorOf(primitive.attributes, "POSITION"), kGltfPositions);
  addTargets(values, primitive, instance.morphWeights, positions);
  Eigen::Matrix3Xd vertices =
      Eigen::Matrix3Xd::Map(positions.data(), 3, static_cast<Eigen::Index>(positions.size() / 3));
  if (instance.worldFromMesh.empty() || accessorOf(primitive.attributes, "JOINTS_0") < 0) {
    return instance.worldFromNode * vertices;
  }
  Skinning skinning(values, instance.worldFromMesh, vertices.cols());
  for (int set = 0;; ++set) {
    const int joints = accessorOf(primitive.attributes, fmt::format("JOINTS_{}", set));
    const int weights = accessorOf(primitive.attributes, fmt::format("WEIGHTS_{}", set));
    if (joints < 0 || weights < 0) break;
    skinning.addSet(joints, weights);
  }
  skinning.move(vertices);
  return vertices;
}

}  // namespace morphgrid
