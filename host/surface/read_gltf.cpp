#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <map>
#include <numeric>

#include "surface/gltf_model.h"
#include "surface/gltf_values.h"
#include "surface/mesh_formats.h"

namespace morphgrid {
namespace {

using Transform = Eigen::Affine3d;

/// Nodes may show a mesh again and again: so many values in memory for each byte of the file.
const std::size_t kMostValuesPerByte = 100;

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

/// The corners of separate triangles, from those of a list, a strip or a fan.
std::vector<int> separateTriangles(const std::vector<int>& corners, int mode) {
  if (mode == TINYGLTF_MODE_TRIANGLES) return corners;
  std::vector<int> result;
  for (std::size_t i = 2; i < corners.size(); ++i) {
    const std::size_t flip = i % 2;
    const std::array<int, 3> triangle =
        mode == TINYGLTF_MODE_TRIANGLE_FAN
            ? std::array{corners[0], corners[i - 1], corners[i]}
            : std::array{corners[i - 2], corners[i - 1 + flip], corners[i - flip]};
    result.insert(result.end(), triangle.begin(), triangle.end());
  }
  return result;
}

class GltfReader {
 public:
  explicit GltfReader(const MeshSource& source) : source_(source), model_(readGltfModel(source)) {
    for (const tinygltf::Buffer& buffer : model_.buffers) mostValues_ += buffer.data.size();
    mostValues_ =
        std::min(kMostValuesPerByte * (mostValues_ + source.bytes.size()), kMostMeshBytes);
  }

  TriangleMesh read() {
    addNodes();
    TriangleMesh mesh;
    mesh.vertices = Eigen::Matrix3Xd::Map(coordinates_.data(), 3, coordinates_.size() / 3);
    mesh.triangles = Eigen::Matrix3Xi::Map(corners_.data(), 3, corners_.size() / 3);
    return mesh;
  }

 private:
  struct Visit {
    int node;
    Transform worldFromParent;
  };

  /// Walks the scene. A node that comes up twice is its own ancestor or has two parents: neither is
  /// allowed, and the walk might not end.
  void addNodes() {
    std::vector<Visit> left;
    for (const int root : roots()) left.push_back({root, Transform::Identity()});
    std::vector<bool> visited(model_.nodes.size());
    while (!left.empty()) {
      const auto [index, worldFromParent] = left.back();
      left.pop_back();
      const tinygltf::Node& node = itemAt(source_, model_.nodes, index, "node");
      if (visited[index]) throw source_.error(fmt::format("node {} has two parents", index));
      visited[index] = true;
      const Transform worldFromNode = worldFromParent * parentFromNode(source_, node);
      // Joints, not its node, place a skinned mesh: it stays as it was when bound to them.
      if (node.mesh >= 0)
        addMesh(node.mesh, node.skin >= 0 ? Transform::Identity() : worldFromNode);
      for (const int child : node.children) left.push_back({child, worldFromNode});
    }
  }

  std::vector<int> roots() const {
    if (model_.scenes.empty()) return nodesWithoutParent();
    return itemAt(source_, model_.scenes, std::max(model_.defaultScene, 0), "scene").nodes;
  }

  std::vector<int> nodesWithoutParent() const {
    std::vector<bool> hasParent(model_.nodes.size());
    for (const tinygltf::Node& node : model_.nodes) {
      for (const int child : node.children) {
        itemAt(source_, model_.nodes, child, "node");
        hasParent[child] = true;
      }
    }
    std::vector<int> result;
    for (std::size_t i = 0; i < hasParent.size(); ++i) {
      if (!hasParent[i]) result.push_back(static_cast<int>(i));
    }
    return result;
  }

  void addMesh(int index, const Transform& worldFromMesh) {
    std::map<int, Vertices> added;  // Primitives often share their vertices.
    for (const tinygltf::Primitive& primitive :
         itemAt(source_, model_.meshes, index, "mesh").primitives) {
      if (primitive.mode < TINYGLTF_MODE_POINTS || primitive.mode > TINYGLTF_MODE_TRIANGLE_FAN) {
        throw source_.error(
            fmt::format("mesh {}: a mode must be 0 to 6, got {}", index, primitive.mode));
      }
      const auto positions = primitive.attributes.find("POSITION");
      if (primitive.mode < TINYGLTF_MODE_TRIANGLES || positions == primitive.attributes.end()) {
        continue;  // Points and lines.
      }
      auto [vertices, isNew] = added.try_emplace(positions->second);
      if (isNew) vertices->second = addVertices(positions->second, worldFromMesh);
      addTriangles(primitive, vertices->second);
    }
  }

  struct Vertices {
    int first = 0;
    int count = 0;
  };

  Vertices addVertices(int accessor, const Transform& worldFromMesh) {
    std::vector<double> positions = readVectors(source_, model_, accessor);
    const Vertices added{static_cast<int>(coordinates_.size() / 3),
                         static_cast<int>(positions.size() / 3)};
    auto columns = Eigen::Matrix3Xd::Map(positions.data(), 3, added.count);
    columns = worldFromMesh * columns;
    requireRoom(positions.size());
    coordinates_.insert(coordinates_.end(), positions.begin(), positions.end());
    return added;
  }

  void addTriangles(const tinygltf::Primitive& primitive, const Vertices& vertices) {
    std::vector<int> corners(vertices.count);
    if (primitive.indices < 0) {
      std::iota(corners.begin(), corners.end(), 0);
    } else {
      corners = readIndices(source_, model_, primitive.indices, vertices.count);
    }
    corners = separateTriangles(corners, primitive.mode);
    if (corners.size() % 3 != 0) {
      throw source_.error(fmt::format(
          "a primitive of triangles has {} corners: not a multiple of 3", corners.size()));
    }
    requireRoom(corners.size());
    for (const int corner : corners) corners_.push_back(vertices.first + corner);
  }

  void requireRoom(std::size_t values) const {
    if (coordinates_.size() + corners_.size() + values <= mostValues_) return;
    throw source_.error("its nodes repeat its meshes more often than can be held in memory");
  }

  const MeshSource& source_;
  tinygltf::Model model_;
  std::size_t mostValues_ = 0;
  std::vector<double> coordinates_;
  std::vector<int> corners_;
};

}  // namespace

NotedMesh readGltf(const MeshSource& source) { return {GltfReader(source).read(), {}}; }

}  // namespace morphgrid
