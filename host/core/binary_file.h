#pragma once
#include <Eigen/Core>
#include <bit>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace morphgrid {

static_assert(std::endian::native == std::endian::little, "binary files are little-endian");

/// A kind of binary file: a line `morphgrid NAME VERSION`, values as BinaryWriter lays them out,
/// and the CRC-32 of all that.
struct BinaryFormat {
  std::string_view name;    ///< One word.
  int version;              ///< The only one that is read.
  std::string_view advice;  ///< What to do about a file that cannot be used, for its user.
};

/// Lays values one after the other, little-endian: integers and numbers in 8 bytes, texts and lists
/// after their count.
class BinaryWriter {
 public:
  BinaryWriter& integer(std::int64_t value);
  BinaryWriter& number(double value);
  BinaryWriter& text(std::string_view value);
  BinaryWriter& numbers(std::span<const double> values);
  BinaryWriter& numbers(const Eigen::VectorXd& values);
  /// 3 x n; n is its count.
  BinaryWriter& points(const Eigen::Matrix3Xd& values);

  const std::string& bytes() const { return bytes_; }

 private:
  void raw(const void* data, std::size_t size);

  std::string bytes_;
};

/// Takes values in the order in which a BinaryWriter got them. All throw Error where fewer are left
/// than are asked for or announced.
class BinaryReader {
 public:
  class Error : public std::runtime_error {
   public:
    using std::runtime_error::runtime_error;
  };

  /// bytes must outlive the reader.
  explicit BinaryReader(std::string_view bytes) : bytes_(bytes) {}

  std::int64_t integer();
  /// Throws Error where the integer is outside [low, high].
  std::int64_t integer(std::int64_t low, std::int64_t high);
  double number();
  std::string text();
  std::vector<double> numbers();
  Eigen::VectorXd vector();
  Eigen::Matrix3Xd points();
  /// How many entries of at least `leastBytes` bytes each follow.
  std::size_t count(std::size_t leastBytes);

  void requireEnd() const;

 private:
  void raw(void* data, std::size_t size);

  std::string_view bytes_;
};

/// 64 bits of FNV-1a, as 16 hexadecimal digits: tells things apart, but is no defence.
std::string digestOf(std::string_view bytes);

/// Replaces the file as a whole. Throws InputError when the disk refuses.
void writeBinaryFile(const std::filesystem::path& file, const BinaryFormat& format,
                     const BinaryWriter& content);

/// The bytes that a BinaryReader takes apart. Throws InputError, with the format's advice, when the
/// file cannot be read, is of another kind or version or damaged.
std::string readBinaryContent(const std::filesystem::path& file, const BinaryFormat& format);

/// Whether a file begins as those of this kind, of any version, do.
bool isBinaryFile(const std::filesystem::path& file, const BinaryFormat& format);

[[noreturn]] void refuseDamaged(const std::filesystem::path& file, const BinaryFormat& format);

/// What parse(BinaryReader&) makes of the whole content. Throws InputError as readBinaryContent()
/// does, and where parse throws BinaryReader::Error or leaves something over.
template <typename Parse>
auto readBinaryFile(const std::filesystem::path& file, const BinaryFormat& format,
                    const Parse& parse) {
  const std::string content = readBinaryContent(file, format);
  BinaryReader reader(content);
  try {
    auto result = parse(reader);
    reader.requireEnd();
    return result;
  } catch (const BinaryReader::Error&) {
    refuseDamaged(file, format);
  }
}

}  // namespace morphgrid
