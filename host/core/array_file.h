#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace morphgrid {

/// The largest number up to which a double holds every integer, in powers of ten.
inline constexpr double kLargestExactInteger = 1e15;

/// Files of named arrays and texts: the safetensors format
/// (https://github.com/huggingface/safetensors), little-endian, whose last array is a checksum of
/// all before it.

enum class ElementType { float64, int32, uint32, uint8 };

/// How many elements along each index; empty: one value.
using ArrayShape = std::vector<std::size_t>;

inline std::size_t elementCount(const ArrayShape& shape) {
  std::size_t count = 1;
  for (const std::size_t extent : shape) count *= extent;
  return count;
}

/// An array that lies elsewhere: row-major, the last index the fastest.
struct ArrayView {
  ElementType type;
  ArrayShape shape;
  std::string_view bytes;  ///< In this machine's order.
};

/// values: as many as the shape holds.
ArrayView viewOf(ArrayShape shape, std::span<const double> values);
ArrayView viewOf(ArrayShape shape, std::span<const std::int32_t> values);
ArrayView viewOf(ArrayShape shape, std::span<const std::uint8_t> values);

/// A kind of such files.
struct ArrayFormat {
  std::string_view name;    ///< Its mark, e.g. "morphgrid state".
  int version;              ///< What is written; nothing else is read.
  std::string_view noun;    ///< For people, e.g. "state".
  std::string_view advice;  ///< What to do about one that will not do, e.g. "run the scene again".
};

struct NamedText {
  std::string name, text;
};
struct NamedArray {
  std::string name;
  ArrayView array;
};

/// Replaces the file as a whole. Names are unique; a text's may be that of an array. Throws
/// InputError when the disk refuses, or the texts exceed 16 MiB.
void writeArrayFile(const std::filesystem::path& file, const ArrayFormat& format,
                    const std::vector<NamedText>& texts, const std::vector<NamedArray>& arrays);

/// Such a file, read and checked as a whole; what it holds may still make no sense.
class ArrayFile {
 public:
  /// Throws InputError when the file cannot be read, is of another kind, damaged, cut short or of
  /// another version. Takes no more memory than the file has bytes, and 16 MiB of texts.
  ArrayFile(const std::filesystem::path& file, const ArrayFormat& format);

  /// Throws InputError: the file is damaged. For contents that contradict each other.
  [[noreturn]] void refuse() const;

  bool has(const std::string& array) const { return arrays_.contains(array); }
  /// Throws InputError when there is none of that name.
  const std::string& text(const std::string& name) const;
  const std::map<std::string, std::string>& texts() const { return texts_; }
  const ArrayShape& shapeOf(const std::string& array) const;

  /// Copies an array. Throws InputError when there is none of that name, of another type or size.
  void copy(const std::string& array, std::span<double> values) const;
  void copy(const std::string& array, std::span<std::int32_t> values) const;
  void copy(const std::string& array, std::span<std::uint8_t> values) const;

 private:
  const ArrayView& find(const std::string& array) const;
  void copyBytes(const std::string& array, ElementType type, std::span<std::byte> bytes) const;

  std::filesystem::path file_;
  ArrayFormat format_;
  std::map<std::string, std::string> texts_;
  std::map<std::string, ArrayView> arrays_;
  std::unique_ptr<char[]> bytes_;
};

/// Whether a file begins as one of that kind does; false when it cannot be read.
bool looksLike(const ArrayFormat& format, const std::filesystem::path& file);

}  // namespace morphgrid
