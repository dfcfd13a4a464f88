#pragma once
#include <initializer_list>
#include <string_view>
#include <vector>

#include "surface/gltf_model.h"

namespace morphgrid {

/// What an accessor may hold, in tinygltf's numbers.
struct GltfKind {
  int type;
  std::initializer_list<int> componentTypes;
  std::string_view wanted;  ///< The same in words.
};

extern const GltfKind kGltfPositions;  ///< Floats, or the integers of KHR_mesh_quantization.
extern const GltfKind kGltfIndices;
extern const GltfKind kGltfJoints;
extern const GltfKind kGltfWeights;
extern const GltfKind kGltfMatrices;

/// Reads accessors. A file may have its values read again and again, and an accessor without a
/// buffer view holds as many as it likes: what is read is bounded by the size of the file with its
/// buffers.
class GltfValues {
 public:
  /// Keeps a reference to the model.
  explicit GltfValues(const GltfModel& model);

  /// The components of all elements, one element after the other; zeros where an accessor has no
  /// buffer view, and sparse ones put in their places. Throws InputError when the accessor is of
  /// another kind, lies outside of its buffer or holds what is not finite.
  std::vector<double> read(int accessor, const GltfKind& kind);

  /// The vertices of triangles. Throws alike, and when one is not below `vertexCount`.
  std::vector<int> readIndices(int accessor, std::size_t vertexCount);

  /// How many elements an accessor says that it has.
  std::size_t countOf(int accessor) const;

  /// Throws InputError when `count` more values exceed what may be read.
  void requireRoom(std::size_t count);

  const GltfModel& model() const { return model_; }

 private:
  void placeSparse(int accessor, int componentCount, std::vector<double>& values) const;

  const GltfModel& model_;
  std::size_t valuesLeft_ = 0;
};

}  // namespace morphgrid
