#include "export/gltf_parts.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <sstream>

#include "core/atomic_file.h"
#include "core/error.h"
#include "export/bar_mesh.h"
#include "grid/strain.h"
#include "shared/strain_color.h"

namespace morphgrid {
namespace {

const char* const kUnlit = "KHR_materials_unlit";
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

/// Lines have no normals to shade by, and their colours are data.
tinygltf::Material lineMaterial() {
  tinygltf::Material material;
  material.name = "strain";
  material.extensions[kUnlit] = tinygltf::Value(tinygltf::Value::Object());
  return material;
}

/// Without light nobody could tell the sides of a bar.
tinygltf::Material barMaterial() {
  tinygltf::Material material;
  material.name = "strain";
  material.pbrMetallicRoughness.metallicFactor = 0;
  material.pbrMetallicRoughness.roughnessFactor = 0.8;
  return material;
}

/// The strain's colour of every strut, once for each of its vertices.
Eigen::Matrix3Xf strutColors(const StrutGrid& grid, const Eigen::Matrix3Xd& positions,
                             int verticesPerStrut) {
  const std::vector<double> strutStrains = strains(grid, positions);
  Eigen::Matrix3Xf colors(3, verticesPerStrut * strutStrains.size());
  for (std::size_t i = 0; i < strutStrains.size(); ++i) {
    const vec3 color = strainColor(static_cast<float>(strutStrains[i]));
    colors.middleCols(verticesPerStrut * i, verticesPerStrut).colwise() =
        Eigen::Vector3f(color.r, color.g, color.b);
  }
  return colors;
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
    throw InputError(fmt::format("{}: cannot be written: {} bytes of geometry, glTF holds 2 GiB",
                                 path.string(), size));
  }
}

}  // namespace

tinygltf::Model emptyModel() {
  tinygltf::Model model;
  model.asset.version = "2.0";
  model.asset.generator = "morphgrid";
  model.extensionsUsed = {kUnlit};
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

Eigen::Matrix3Xf strutVertices(const StrutGrid& grid, const Eigen::Matrix3Xd& positions,
                               const JointRotations& rotations) {
  if (grid.bars) {
    return barVertices(grid, positions, rotations).cast<float>();
  }
  Eigen::Matrix3Xf ends(3, 2 * grid.shape.strutCount());
  Eigen::Index n = 0;
  forEachStrut(grid.shape, [&](const Strut& strut) {
    ends.col(n++) = positions.col(strut.from).cast<float>();
    ends.col(n++) = positions.col(strut.to).cast<float>();
  });
  return ends;
}

tinygltf::Primitive addStruts(tinygltf::Model& model, const StrutGrid& grid,
                              const Eigen::Matrix3Xd& positions, const JointRotations& rotations) {
  tinygltf::Primitive struts;
  struts.mode = grid.bars ? TINYGLTF_MODE_TRIANGLES : TINYGLTF_MODE_LINE;
  struts.attributes["POSITION"] = addPositions(model, strutVertices(grid, positions, rotations));
  struts.attributes["COLOR_0"] =
      addVectors(model, strutColors(grid, positions, grid.bars ? kBarMeshVertices : 2));
  if (grid.bars) {
    struts.indices = addIndices(model, barTriangles(grid.shape));
  }
  return struts;
}

void addStrutNode(tinygltf::Model& model, tinygltf::Primitive struts) {
  const bool areLines = struts.mode == TINYGLTF_MODE_LINE;
  addNode(model, "struts", areLines ? lineMaterial() : barMaterial(), std::move(struts));
}

void addSurfaceNode(tinygltf::Model& model, tinygltf::Primitive triangles) {
  triangles.mode = TINYGLTF_MODE_TRIANGLES;
  addNode(model, "surface", surfaceMaterial(), std::move(triangles));
}

void requireFloats(const std::filesystem::path& path, const Eigen::Matrix3Xd& values) {
  if (!values.cast<float>().allFinite()) {
    throw InputError(fmt::format(
        "{}: cannot be written: glTF holds 32-bit floats, and a coordinate is not finite as one",
        path.string()));
  }
}

void writeModel(const std::filesystem::path& path, tinygltf::Model& model) {
  requireSize(path, model);
  std::ostringstream stream;
  tinygltf::TinyGLTF().WriteGltfSceneToStream(&model, stream, /*prettyPrint=*/false,
                                              /*writeBinary=*/true);
  writeFileAtomically(path, stream.view());
}

}  // namespace morphgrid
