#pragma once
#include <gtest/gtest.h>
#include <tiny_gltf.h>

#include <Eigen/Core>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace morphgrid {

inline tinygltf::Model loadGltf(const std::filesystem::path& path) {
  tinygltf::Model model;
  std::string errors, warnings;
  EXPECT_TRUE(tinygltf::TinyGLTF().LoadBinaryFromFile(&model, &errors, &warnings, path));
  EXPECT_EQ(errors, "");
  EXPECT_EQ(warnings, "");
  return model;
}

/// The accessor's values as `rows` x count.
template <typename Scalar>
Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic> values(const tinygltf::Model& model,
                                                             int accessorIndex, int rows) {
  const tinygltf::Accessor& accessor = model.accessors.at(accessorIndex);
  const tinygltf::BufferView& view = model.bufferViews.at(accessor.bufferView);
  const std::vector<unsigned char>& bytes = model.buffers.at(view.buffer).data;
  EXPECT_EQ(tinygltf::GetComponentSizeInBytes(accessor.componentType), sizeof(Scalar));
  EXPECT_EQ(tinygltf::GetNumComponentsInType(accessor.type), rows);
  EXPECT_EQ(view.byteLength, accessor.count * rows * sizeof(Scalar));
  EXPECT_LE(view.byteOffset + view.byteLength, bytes.size());
  EXPECT_EQ(view.byteOffset % 4, 0);
  Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic> result(rows, accessor.count);
  std::memcpy(result.data(), bytes.data() + view.byteOffset, view.byteLength);
  return result;
}

inline const tinygltf::Primitive& onlyPrimitive(const tinygltf::Model& model,
                                                const std::string& name) {
  for (const tinygltf::Node& node : model.nodes) {
    if (node.name == name) {
      EXPECT_EQ(model.meshes.at(node.mesh).primitives.size(), 1);
      return model.meshes.at(node.mesh).primitives.front();
    }
  }
  throw std::runtime_error("no node " + name);
}

/// Expects an accessor's bounds, a number for each component of its type, to be those of its
/// values.
inline void expectBounds(const tinygltf::Model& model, int accessorIndex) {
  const tinygltf::Accessor& accessor = model.accessors.at(accessorIndex);
  const int rows = tinygltf::GetNumComponentsInType(accessor.type);
  const Eigen::MatrixXf positions = values<float>(model, accessorIndex, rows);
  ASSERT_EQ(accessor.minValues.size(), rows);
  ASSERT_EQ(accessor.maxValues.size(), rows);
  for (int axis = 0; axis < rows; ++axis) {
    EXPECT_EQ(accessor.minValues[axis], positions.row(axis).minCoeff());
    EXPECT_EQ(accessor.maxValues[axis], positions.row(axis).maxCoeff());
  }
}

}  // namespace morphgrid
