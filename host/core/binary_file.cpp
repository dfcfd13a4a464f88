#include "core/binary_file.h"

#include <fmt/format.h>
#include <zlib.h>

#include <cstring>
#include <fstream>

#include "core/atomic_file.h"
#include "core/error.h"
#include "core/read_file.h"

namespace morphgrid {
namespace {

[[noreturn]] void refuseFile(const std::filesystem::path& file, std::string_view why) {
  throw InputError(fmt::format("{}: {}", file.string(), why));
}

std::uint32_t checksum(std::string_view bytes) {
  return static_cast<std::uint32_t>(
      crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

std::string magicOf(const BinaryFormat& format) {
  return fmt::format("morphgrid {} ", format.name);
}

}  // namespace

void BinaryWriter::raw(const void* data, std::size_t size) {
  bytes_.append(static_cast<const char*>(data), size);
}

BinaryWriter& BinaryWriter::integer(std::int64_t value) {
  raw(&value, sizeof(value));
  return *this;
}

BinaryWriter& BinaryWriter::number(double value) {
  raw(&value, sizeof(value));
  return *this;
}

BinaryWriter& BinaryWriter::text(std::string_view value) {
  integer(static_cast<std::int64_t>(value.size()));
  raw(value.data(), value.size());
  return *this;
}

BinaryWriter& BinaryWriter::numbers(std::span<const double> values) {
  integer(static_cast<std::int64_t>(values.size()));
  raw(values.data(), values.size_bytes());
  return *this;
}

BinaryWriter& BinaryWriter::numbers(const Eigen::VectorXd& values) {
  return numbers(std::span(values.data(), static_cast<std::size_t>(values.size())));
}

BinaryWriter& BinaryWriter::points(const Eigen::Matrix3Xd& values) {
  integer(values.cols());
  raw(values.data(), static_cast<std::size_t>(values.size()) * sizeof(double));
  return *this;
}

void BinaryReader::raw(void* data, std::size_t size) {
  if (size > bytes_.size()) {
    throw Error("fewer bytes than announced");
  }
  if (size > 0) {
    std::memcpy(data, bytes_.data(), size);
  }
  bytes_.remove_prefix(size);
}

std::int64_t BinaryReader::integer() {
  std::int64_t value = 0;
  raw(&value, sizeof(value));
  return value;
}

std::int64_t BinaryReader::integer(std::int64_t low, std::int64_t high) {
  const std::int64_t value = integer();
  if (value < low || value > high) {
    throw Error(fmt::format("{} is not within {} and {}", value, low, high));
  }
  return value;
}

double BinaryReader::number() {
  double value = 0;
  raw(&value, sizeof(value));
  return value;
}

std::size_t BinaryReader::count(std::size_t leastBytes) {
  const std::int64_t count = integer();
  if (count < 0 || static_cast<std::size_t>(count) > bytes_.size() / leastBytes) {
    throw Error("fewer bytes than announced");
  }
  return static_cast<std::size_t>(count);
}

std::string BinaryReader::text() {
  std::string value(count(1), '\0');
  raw(value.data(), value.size());
  return value;
}

std::vector<double> BinaryReader::numbers() {
  std::vector<double> values(count(sizeof(double)));
  raw(values.data(), values.size() * sizeof(double));
  return values;
}

Eigen::VectorXd BinaryReader::vector() {
  Eigen::VectorXd values(static_cast<Eigen::Index>(count(sizeof(double))));
  raw(values.data(), static_cast<std::size_t>(values.size()) * sizeof(double));
  return values;
}

Eigen::Matrix3Xd BinaryReader::points() {
  Eigen::Matrix3Xd values(3, static_cast<Eigen::Index>(count(3 * sizeof(double))));
  raw(values.data(), static_cast<std::size_t>(values.size()) * sizeof(double));
  return values;
}

void BinaryReader::requireEnd() const {
  if (!bytes_.empty()) {
    throw Error("more bytes than announced");
  }
}

std::string digestOf(std::string_view bytes) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char byte : bytes) {
    hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3;
  }
  return fmt::format("{:016x}", hash);
}

void writeBinaryFile(const std::filesystem::path& file, const BinaryFormat& format,
                     const BinaryWriter& content) {
  std::string bytes = fmt::format("{}{}\n", magicOf(format), format.version);
  bytes += content.bytes();
  const std::uint32_t sum = checksum(bytes);
  bytes.append(reinterpret_cast<const char*>(&sum), sizeof(sum));
  writeFileAtomically(file, bytes);
}

void refuseDamaged(const std::filesystem::path& file, const BinaryFormat& format) {
  refuseFile(file, fmt::format("the {} is damaged or cut short; {}", format.name, format.advice));
}

std::string readBinaryContent(const std::filesystem::path& file, const BinaryFormat& format) {
  std::string bytes = readFile(file);
  const std::string magic = magicOf(format);
  if (!bytes.starts_with(magic)) {
    refuseFile(file, fmt::format("is no {} of morphgrid; {}", format.name, format.advice));
  }
  const auto end = bytes.find('\n');
  if (end == std::string::npos) {
    refuseDamaged(file, format);
  }
  const auto version = std::string_view(bytes).substr(magic.size(), end - magic.size());
  if (version != std::to_string(format.version)) {
    refuseFile(file, fmt::format("the {} has format {}, this morphgrid reads format {}; use the "
                                 "version that wrote it, or {}",
                                 format.name, version, format.version, format.advice));
  }
  std::uint32_t sum = 0;
  if (bytes.size() < end + 1 + sizeof(sum)) {
    refuseDamaged(file, format);
  }
  std::memcpy(&sum, bytes.data() + bytes.size() - sizeof(sum), sizeof(sum));
  bytes.resize(bytes.size() - sizeof(sum));
  if (checksum(bytes) != sum) {
    refuseDamaged(file, format);
  }
  return bytes.substr(end + 1);
}

bool isBinaryFile(const std::filesystem::path& file, const BinaryFormat& format) {
  const std::string magic = magicOf(format);
  std::ifstream stream(file, std::ios::binary);
  std::string start(magic.size(), '\0');
  stream.read(start.data(), static_cast<std::streamsize>(start.size()));
  return stream && start == magic;
}

}  // namespace morphgrid
