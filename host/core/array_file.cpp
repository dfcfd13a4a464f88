#include "core/array_file.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>

#include "core/atomic_file.h"
#include "core/output_error.h"
#include "core/read_file.h"

namespace morphgrid {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

static_assert(std::endian::native == std::endian::little, "the files are little-endian");

// A file: the length of the header, the header in JSON, the arrays. Spaces fill the header up, so
// that the arrays are aligned.
constexpr std::size_t kLengthBytes = sizeof(std::uint64_t);
constexpr std::size_t kAlignment = 8;
constexpr std::size_t kLargestHeader = std::size_t{1} << 24;
constexpr const char* kTextsKey = "__metadata__";
constexpr const char* kChecksumName = "crc32";

struct TypeName {
  ElementType type;
  std::string_view name;
  std::size_t size;
};
constexpr TypeName kTypes[] = {{ElementType::float64, "F64", 8},
                               {ElementType::int32, "I32", 4},
                               {ElementType::uint32, "U32", 4},
                               {ElementType::uint8, "U8", 1}};

const TypeName& nameOf(ElementType type) {
  return *std::ranges::find(kTypes, type, &TypeName::type);
}

/// Contradictions within a file.
class Damage : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

void require(bool holds, const char* what) {
  if (!holds) throw Damage(what);
}

std::uint32_t extend(std::uint32_t sum, std::string_view bytes) {
  if (bytes.empty()) return sum;  // zlib takes no bytes at no address for a new sum.
  return static_cast<std::uint32_t>(
      crc32_z(sum, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

template <typename T>
std::string_view bytesOf(const T& value) {
  return {reinterpret_cast<const char*>(&value), sizeof(value)};
}

template <typename T>
std::string_view bytesOf(std::span<const T> values) {
  return {reinterpret_cast<const char*>(values.data()), values.size_bytes()};
}

/// What follows the length of the header: files of a kind begin alike.
std::string markOf(const ArrayFormat& format) {
  return fmt::format(R"({{"{}":{{"format":"{}",)", kTextsKey, format.name);
}

ordered_json entryOf(const ArrayView& array, std::size_t& end) {
  const std::size_t begin = end;
  end += array.bytes.size();
  return {
      {"dtype", nameOf(array.type).name}, {"shape", array.shape}, {"data_offsets", {begin, end}}};
}

/// The header and the length before it.
std::string headerOf(const ArrayFormat& format, const std::vector<NamedText>& texts,
                     const std::vector<NamedArray>& arrays) {
  ordered_json header;
  header[kTextsKey] = {{"format", format.name}, {"version", std::to_string(format.version)}};
  for (const NamedText& text : texts) {
    header[kTextsKey][text.name] = text.text;
  }
  std::size_t end = 0;
  for (const NamedArray& array : arrays) {
    header[array.name] = entryOf(array.array, end);
  }
  header[kChecksumName] = entryOf({ElementType::uint32, {1}, bytesOf(std::uint32_t{})}, end);
  // Paths need not be UTF-8: what is not is replaced.
  std::string text = header.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
  text.resize((text.size() + kAlignment - 1) / kAlignment * kAlignment, ' ');
  const std::uint64_t length = text.size();
  return std::string(bytesOf(length)) + text;
}

std::size_t count(const json& number) {
  require(number.is_number_unsigned(), "no count");
  return number.get<std::size_t>();
}

/// Throws Damage when the bytes of an array of that shape cannot be counted.
std::size_t byteCount(const std::vector<std::size_t>& shape, std::size_t elementSize) {
  std::size_t bytes = elementSize;
  for (const std::size_t extent : shape) {
    require(extent == 0 || bytes <= std::numeric_limits<std::size_t>::max() / extent, "too large");
    bytes *= extent;
  }
  return bytes;
}

/// An array as a header announces it, before its bytes are there.
struct Announced {
  std::string name;
  ElementType type;
  std::vector<std::size_t> shape;
  std::size_t begin, end;
};

Announced announced(const std::string& name, const json& entry) {
  const auto* type =
      std::ranges::find(kTypes, entry.at("dtype").get_ref<const std::string&>(), &TypeName::name);
  require(type != std::end(kTypes), "unknown type");
  const json& extents = entry.at("shape");
  const json& offsets = entry.at("data_offsets");
  require(extents.is_array() && offsets.is_array(), "no list");
  std::vector<std::size_t> shape;
  std::ranges::transform(extents, std::back_inserter(shape), count);
  const std::size_t begin = count(offsets.at(0));
  const std::size_t end = count(offsets.at(1));
  require(begin <= end && end - begin == byteCount(shape, type->size), "shape and size differ");
  return {name, type->type, std::move(shape), begin, end};
}

/// The arrays of a header, which follow each other to the end of the data, the checksum last.
std::vector<Announced> arraysOf(const json& header, std::size_t dataBytes) {
  std::vector<Announced> arrays;
  for (const auto& [name, entry] : header.items()) {
    if (name != kTextsKey) arrays.push_back(announced(name, entry));
  }
  std::ranges::sort(arrays, {},
                    [](const Announced& array) { return std::pair(array.begin, array.end); });
  std::size_t end = 0;
  for (const Announced& array : arrays) {
    require(array.begin == end, "a gap");
    end = array.end;
  }
  require(end == dataBytes, "not as long as announced");
  require(!arrays.empty() && arrays.back().name == kChecksumName &&
              arrays.back().end - arrays.back().begin == sizeof(std::uint32_t),
          "no checksum at the end");
  return arrays;
}

/// A file's bytes, in order.
class Source {
 public:
  explicit Source(const std::filesystem::path& file) : stream_(file, std::ios::binary) {
    std::error_code error;
    left_ = std::filesystem::file_size(file, error);
    require(!error, "no size");
  }

  std::size_t left() const { return left_; }
  void read(char* to, std::size_t bytes) {
    require(bytes <= left_, "cut short");
    stream_.read(to, static_cast<std::streamsize>(bytes));
    require(static_cast<bool>(stream_), "cannot be read");
    left_ -= bytes;
  }

 private:
  std::ifstream stream_;
  std::size_t left_ = 0;
};

/// The header, its length before it.
std::string readHeader(Source& source) {
  std::uint64_t length = 0;
  source.read(reinterpret_cast<char*>(&length), kLengthBytes);
  require(length <= kLargestHeader && length <= source.left(), "no header");
  std::string header(kLengthBytes + length, '\0');
  std::memcpy(header.data(), &length, kLengthBytes);
  source.read(header.data() + kLengthBytes, length);
  return header;
}

void requireChecksum(std::string_view header, std::string_view data) {
  const std::string_view covered = data.substr(0, data.size() - sizeof(std::uint32_t));
  const std::uint32_t sum = extend(extend(0, header), covered);
  require(bytesOf(sum) == data.substr(covered.size()), "another checksum");
}

[[noreturn]] void refuseFile(const std::filesystem::path& file, const ArrayFormat& format,
                             const std::string& why) {
  throw InputError(fmt::format("{}: {}; {}", file.string(), why, format.advice));
}

}  // namespace

ArrayView viewOf(ArrayShape shape, std::span<const double> values) {
  return {ElementType::float64, std::move(shape), bytesOf(values)};
}
ArrayView viewOf(ArrayShape shape, std::span<const std::int32_t> values) {
  return {ElementType::int32, std::move(shape), bytesOf(values)};
}
ArrayView viewOf(ArrayShape shape, std::span<const std::uint8_t> values) {
  return {ElementType::uint8, std::move(shape), bytesOf(values)};
}

void writeArrayFile(const std::filesystem::path& file, const ArrayFormat& format,
                    const std::vector<NamedText>& texts, const std::vector<NamedArray>& arrays) {
  const std::string header = headerOf(format, texts, arrays);
  if (header.size() - kLengthBytes > kLargestHeader) {
    throw OutputError(fmt::format("{}: cannot be written: the texts of the {} exceed {} MiB",
                                  file.string(), format.noun, kLargestHeader >> 20));
  }
  writeFileAtomically(file, [&](std::ostream& stream) {
    std::uint32_t sum = 0;
    const auto put = [&](std::string_view bytes) {
      stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
      sum = extend(sum, bytes);
    };
    put(header);
    for (const NamedArray& array : arrays) {
      put(array.array.bytes);
    }
    put(std::string(bytesOf(sum)));
  });
}

bool looksLike(const ArrayFormat& format, const std::filesystem::path& file) {
  std::error_code ignored;  // What cannot be read does not look like anything.
  if (!std::filesystem::is_regular_file(file, ignored)) {
    return false;
  }
  const std::string mark = markOf(format);
  std::string start(kLengthBytes + mark.size(), '\0');
  std::ifstream stream(file, std::ios::binary);
  stream.read(start.data(), static_cast<std::streamsize>(start.size()));
  return stream && start.ends_with(mark);
}

ArrayFile::ArrayFile(const std::filesystem::path& file, const ArrayFormat& format)
    : file_(file), format_(format) {
  if (const auto reason = whyUnreadable(file)) {
    throw InputError(fmt::format("{}: cannot be read: {}", file.string(), *reason));
  }
  if (!looksLike(format, file)) {
    refuseFile(file, format, fmt::format("is no {} of morphgrid", format.noun));
  }
  try {
    Source source(file);
    const std::string header = readHeader(source);
    const json content = json::parse(std::string_view(header).substr(kLengthBytes));
    const std::size_t dataBytes = source.left();
    const std::vector<Announced> arrays = arraysOf(content, dataBytes);
    bytes_ = std::make_unique_for_overwrite<char[]>(dataBytes);
    source.read(bytes_.get(), dataBytes);
    const std::string_view data(bytes_.get(), dataBytes);
    requireChecksum(header, data);
    for (const Announced& array : arrays) {
      arrays_[array.name] = {array.type, array.shape,
                             data.substr(array.begin, array.end - array.begin)};
    }
    texts_ = content.at(kTextsKey).get<std::map<std::string, std::string>>();
  } catch (const Damage&) {
    refuse();
  } catch (const json::exception&) {
    refuse();
  }
  if (const std::string& found = text("version"); found != std::to_string(format.version)) {
    refuseFile(file, format,
               fmt::format("the {} has version {}, this morphgrid reads version {}: use the "
                           "program that wrote it",
                           format.noun, found, format.version));
  }
}

void ArrayFile::refuse() const {
  refuseFile(file_, format_, fmt::format("the {} is damaged or cut short", format_.noun));
}

const std::string& ArrayFile::text(const std::string& name) const {
  const auto found = texts_.find(name);
  if (found == texts_.end()) refuse();
  return found->second;
}

const ArrayView& ArrayFile::find(const std::string& array) const {
  const auto found = arrays_.find(array);
  if (found == arrays_.end()) refuse();
  return found->second;
}

const ArrayShape& ArrayFile::shapeOf(const std::string& array) const { return find(array).shape; }

void ArrayFile::copyBytes(const std::string& array, ElementType type,
                          std::span<std::byte> bytes) const {
  const ArrayView& from = find(array);
  if (from.type != type || from.bytes.size() != bytes.size()) refuse();
  std::ranges::copy(std::as_bytes(std::span(from.bytes)), bytes.begin());
}

void ArrayFile::copy(const std::string& array, std::span<double> values) const {
  copyBytes(array, ElementType::float64, std::as_writable_bytes(values));
}
void ArrayFile::copy(const std::string& array, std::span<std::int32_t> values) const {
  copyBytes(array, ElementType::int32, std::as_writable_bytes(values));
}
void ArrayFile::copy(const std::string& array, std::span<std::uint8_t> values) const {
  copyBytes(array, ElementType::uint8, std::as_writable_bytes(values));
}

}  // namespace morphgrid
