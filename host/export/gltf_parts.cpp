#include "export/gltf_parts.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "core/atomic_file.h"
#include "core/output_error.h"

namespace morphgrid {
namespace {

constexpr int kNoTarget = 0;  // The target of a buffer view that holds no vertices.

/// Appends values to the file's one buffer; returns the new accessor's index.
template <typename Matrix>
int addAccessor(tinygltf::Model& model, const Matrix& values, int target, int componentType,
                int type) {
  std::vector<unsigned char>& bytes = model.buffers.front().data;
  const auto* begin = reinterpret_cast<const unsigned char*>(values.data());
  tinygltf::BufferView view;
  view.buffer = 0;
  view.byteOffset = bytes.size();
  view.byteLength = values.size() * sizeof(typename Matrix::Scalar);
  view.target = target;
  bytes.insert(bytes.end(), begin, begin + view.byteLength);
  model.bufferViews.push_back(view);

  tinygltf::Accessor accessor;
  accessor.bufferView = static_cast<int>(model.bufferViews.size()) - 1;
  accessor.componentType = componentType;
  accessor.type = type;
  accessor.count = values.size() / tinygltf::GetNumComponentsInType(type);
  model.accessors.push_back(accessor);
  return static_cast<int>(model.accessors.size()) - 1;
}

template <typename Matrix>
void setBounds(tinygltf::Accessor& accessor, const Matrix& values) {
  const Eigen::VectorXd low = values.rowwise().minCoeff().template cast<double>();
  const Eigen::VectorXd high = values.rowwise().maxCoeff().template cast<double>();
  accessor.minValues.assign(low.begin(), low.end());
  accessor.maxValues.assign(high.begin(), high.end());
}

tinygltf::Material surfaceMaterial() {
  tinygltf::Material material;
  material.name = "surface";
  material.doubleSided = true;
  material.pbrMetallicRoughness.baseColorFactor = {0.8, 0.8, 0.8, 1};
  material.pbrMetallicRoughness.metallicFactor = 0;
  material.pbrMetallicRoughness.roughnessFactor = 0.6;
  return material;
}

/// tinygltf keeps offsets in an int and would wrap them.
void requireSize(const std::filesystem::path& path, const tinygltf::Model& model) {
  const std::size_t size = model.buffers.front().data.size();
  if (size > std::numeric_limits<int>::max()) {
    throw OutputError(fmt::format("{}: cannot be written: {} bytes of geometry, glTF holds 2 GiB",
                                  path.string(), size));
  }
}

}  // namespace

tinygltf::Model emptyModel() {
  tinygltf::Model model;
  model.asset.version = "2.0";
  model.asset.generator = "morphgrid";
  model.buffers.emplace_back();
  model.scenes.emplace_back();
  model.defaultScene = 0;
  return model;
}

int addScalars(tinygltf::Model& model, const Eigen::VectorXf& scalars) {
  return addAccessor(model, scalars, kNoTarget, TINYGLTF_COMPONENT_TYPE_FLOAT,
                     TINYGLTF_TYPE_SCALAR);
}

int addVectors(tinygltf::Model& model, const Eigen::Matrix3Xf& vectors) {
  return addAccessor(model, vectors, TINYGLTF_TARGET_ARRAY_BUFFER, TINYGLTF_COMPONENT_TYPE_FLOAT,
                     TINYGLTF_TYPE_VEC3);
}

int addIndices(tinygltf::Model& model, const Eigen::Matrix3Xi& triangles) {
  return addAccessor(model, triangles, TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER,
                     TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, TINYGLTF_TYPE_SCALAR);
}

int addPositions(tinygltf::Model& model, const Eigen::Matrix3Xf& positions) {
  const int index = addVectors(model, positions);
  setBounds(model.accessors[index], positions);
  return index;
}

int addTimes(tinygltf::Model& model, const Eigen::VectorXf& seconds) {
  const int index = addScalars(model, seconds);
  setBounds(model.accessors[index], seconds.transpose());
  return index;
}

void addNode(tinygltf::Model& model, const std::string& name, const tinygltf::Material& material,
             tinygltf::Primitive primitive) {
  model.materials.push_back(material);
  primitive.material = static_cast<int>(model.materials.size()) - 1;
  tinygltf::Mesh mesh;
  mesh.name = name;
  mesh.primitives = {primitive};
  model.meshes.push_back(mesh);
  tinygltf::Node node;
  node.name = name;
  node.mesh = static_cast<int>(model.meshes.size()) - 1;
  node.rotation = {-std::sqrt(0.5), 0, 0, std::sqrt(0.5)};
  model.nodes.push_back(node);
  model.scenes.front().nodes.push_back(static_cast<int>(model.nodes.size()) - 1);
}

void addSurfaceNode(tinygltf::Model& model, tinygltf::Primitive triangles) {
  triangles.mode = TINYGLTF_MODE_TRIANGLES;
  addNode(model, "surface", surfaceMaterial(), std::move(triangles));
}

Eigen::Vector3d middleOf(const Eigen::Matrix3Xd& positions) {
  return (positions.rowwise().minCoeff() + positions.rowwise().maxCoeff()) / 2;
}

void placeAt(tinygltf::Model& model, const Eigen::Vector3d& origin) {
  for (tinygltf::Node& node : model.nodes) {
    node.translation = {origin.x(), origin.z(), -origin.y()};
  }
}

void requireFloats(const std::filesystem::path& path, const Eigen::Matrix3Xd& values) {
  if (!values.cast<float>().allFinite()) {
    throw OutputError(fmt::format(
        "{}: cannot be written: glTF holds 32-bit floats, and a coordinate is not finite as one",
        path.string()));
  }
}

void writeModel(const std::filesystem::path& path, tinygltf::Model& model) {
  requireSize(path, model);
  writeFileAtomically(path, [&](std::ostream& stream) {
    tinygltf::TinyGLTF().WriteGltfSceneToStream(&model, stream, /*prettyPrint=*/false,
                                                /*writeBinary=*/true);
  });
}

}  // namespace morphgrid
