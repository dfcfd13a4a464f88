#pragma once
#include <tiny_gltf.h>

#include <Eigen/Core>
#include <filesystem>
#include <string>

namespace morphgrid {

/// Parts of which the glTF files are put together. Numbers go to the model's one buffer; accessors
/// are given by their index.

/// The extension of materials whose colours are shown as they are.
inline constexpr const char* kUnlit = "KHR_materials_unlit";

/// One scene, without nodes yet.
tinygltf::Model emptyModel();

int addScalars(tinygltf::Model& model, const Eigen::VectorXf& scalars);
int addVectors(tinygltf::Model& model, const Eigen::Matrix3Xf& vectors);
int addIndices(tinygltf::Model& model, const Eigen::Matrix3Xi& triangles);

/// With the bounds that the standard wants of positions and of times.
int addPositions(tinygltf::Model& model, const Eigen::Matrix3Xf& positions);
int addTimes(tinygltf::Model& model, const Eigen::VectorXf& seconds);

/// A mesh of one primitive in a node that turns the scene's +z into glTF's up.
void addNode(tinygltf::Model& model, const std::string& name, const tinygltf::Material& material,
             tinygltf::Primitive primitive);
void addSurfaceNode(tinygltf::Model& model, tinygltf::Primitive triangles);

/// Positions are written from here: floats far from their origin are coarse. Of the box around
/// them.
Eigen::Vector3d middleOf(const Eigen::Matrix3Xd& positions);
/// Moves all nodes by what was taken off their positions.
void placeAt(tinygltf::Model& model, const Eigen::Vector3d& origin);

/// Throws InputError naming the path when a number does not fit a float.
void requireFloats(const std::filesystem::path& path, const Eigen::Matrix3Xd& values);

/// Throws InputError naming the path when the file would be beyond glTF's size, or the disk
/// refuses.
void writeModel(const std::filesystem::path& path, tinygltf::Model& model);

}  // namespace morphgrid
