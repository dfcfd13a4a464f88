#include <fmt/format.h>

#include <map>
#include <numeric>

#include "surface/gltf_vertices.h"
#include "surface/mesh_formats.h"
#include "surface/polygon_mesh.h"

namespace morphgrid {
namespace {

/// The corners of separate triangles, from those of a list, a strip or a fan.
std::vector<int> separateTriangles(const std::vector<int>& corners, int mode) {
  if (mode == TINYGLTF_MODE_TRIANGLES) return corners;
  if (mode == TINYGLTF_MODE_TRIANGLE_STRIP) return trianglesOfStrip(corners);
  std::vector<int> result;
  for (std::size_t i = 2; i < corners.size(); ++i) {
    result.insert(result.end(), {corners[0], corners[i - 1], corners[i]});
  }
  return result;
}

class GltfReader {
 public:
  explicit GltfReader(const MeshSource& source)
      : source_(source), model_(readGltfModel(source)), values_(model_) {}

  NotedMesh read() {
    const GltfNodes nodes = placeNodes(model_);
    for (const int node : nodes.shown) {
      const int mesh = model_.items.nodes[node].mesh;
      if (mesh >= 0) addMesh(mesh, instanceOf(values_, nodes, node));
    }
    if (corners_.empty() && pointCount_ > 0) throw pointCloudError(source_, pointCount_);
    TriangleMesh mesh;
    mesh.vertices = Eigen::Matrix3Xd::Map(coordinates_.data(), 3,
                                          static_cast<Eigen::Index>(coordinates_.size() / 3));
    mesh.triangles =
        Eigen::Matrix3Xi::Map(corners_.data(), 3, static_cast<Eigen::Index>(corners_.size() / 3));
    return {std::move(mesh), {}};
  }

 private:
  void addMesh(int index, const GltfInstance& instance) {
    std::map<std::vector<int>, Vertices> added;  // Primitives often share their vertices.
    for (const tinygltf::Primitive& primitive :
         itemAt(source_, model_.items.meshes, index, "mesh").primitives) {
      if (primitive.mode < TINYGLTF_MODE_POINTS || primitive.mode > TINYGLTF_MODE_TRIANGLE_FAN) {
        throw source_.error(
            fmt::format("mesh {}: a mode must be 0 to 6, got {}", index, primitive.mode));
      }
      values_.requireRoom(1 + primitive.attributes.size() + primitive.targets.size());
      const auto positions = primitive.attributes.find("POSITION");
      if (positions == primitive.attributes.end()) continue;
      if (primitive.mode == TINYGLTF_MODE_POINTS) pointCount_ += values_.countOf(positions->second);
      if (primitive.mode < TINYGLTF_MODE_TRIANGLES) continue;  // Points and lines.
      auto [vertices, isNew] = added.try_emplace(vertexSources(primitive));
      if (isNew) vertices->second = addVertices(primitive, instance);
      addTriangles(primitive, vertices->second);
    }
  }

  struct Vertices {
    int first = 0;
    int count = 0;
  };

  Vertices addVertices(const tinygltf::Primitive& primitive, const GltfInstance& instance) {
    const Eigen::Matrix3Xd vertices = readVertices(values_, primitive, instance);
    const Vertices added{static_cast<int>(coordinates_.size() / 3),
                         static_cast<int>(vertices.cols())};
    coordinates_.insert(coordinates_.end(), vertices.data(), vertices.data() + vertices.size());
    return added;
  }

  void addTriangles(const tinygltf::Primitive& primitive, const Vertices& vertices) {
    std::vector<int> corners(vertices.count);
    if (primitive.indices < 0) {
      values_.requireRoom(corners.size());
      std::iota(corners.begin(), corners.end(), 0);
    } else {
      corners = values_.readIndices(primitive.indices, vertices.count);
    }
    corners = separateTriangles(corners, primitive.mode);
    if (corners.size() % 3 != 0) {
      throw source_.error(fmt::format(
          "a primitive of triangles has {} corners: not a multiple of 3", corners.size()));
    }
    for (const int corner : corners) corners_.push_back(vertices.first + corner);
  }

  const MeshSource& source_;
  GltfModel model_;
  GltfValues values_;
  std::size_t pointCount_ = 0;
  std::vector<double> coordinates_;
  std::vector<int> corners_;
};

}  // namespace

NotedMesh readGltf(const MeshSource& source) { return GltfReader(source).read(); }

}  // namespace morphgrid
