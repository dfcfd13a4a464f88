#include "surface/ply_values.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

namespace morphgrid {
namespace {

const char* const kEndsTooSoon = "the file ends before its last value";

}  // namespace

PlyValues::PlyValues(const MeshSource& source, PlyFormat format, TextReader text)
    : source_(source), format_(format), text_(text) {
  text_.skipLine();
  offset_ = text_.offset();
}

double PlyValues::next(PlyType type) {
  if (isAscii()) {
    const std::string_view word = nextWord();
    if (const auto value = parseNumber(word)) return *value;
    throw error("a value must be a number, got " + inQuotes(word));
  }
  switch (type) {
    case PlyType::int8:
      return nextBinary<std::int8_t>();
    case PlyType::uint8:
      return nextBinary<std::uint8_t>();
    case PlyType::int16:
      return nextBinary<std::int16_t>();
    case PlyType::uint16:
      return nextBinary<std::uint16_t>();
    case PlyType::int32:
      return nextBinary<std::int32_t>();
    case PlyType::uint32:
      return nextBinary<std::uint32_t>();
    case PlyType::float32:
      return nextBinary<float>();
    case PlyType::float64:
      return nextBinary<double>();
  }
  return 0;
}

void PlyValues::skip(PlyType type) {
  if (isAscii()) {
    nextWord();
  } else {
    requireBytes(byteCount(type));
    offset_ += byteCount(type);
  }
}

std::string_view PlyValues::nextWord() {
  const std::string_view word = text_.wordOfAnyLine();
  if (word.empty()) throw error(kEndsTooSoon);
  return word;
}

void PlyValues::requireBytes(std::size_t count) const {
  if (bytesLeft() < count) throw error(kEndsTooSoon);
}

template <typename Value>
double PlyValues::nextBinary() {
  std::array<char, sizeof(Value)> bytes{};
  requireBytes(bytes.size());
  std::copy_n(source_.bytes.begin() + offset_, bytes.size(), bytes.begin());
  const bool isLittleEndian = format_ == PlyFormat::binaryLittleEndian;
  if (isLittleEndian != (std::endian::native == std::endian::little)) std::ranges::reverse(bytes);
  offset_ += bytes.size();
  return std::bit_cast<Value>(bytes);
}

std::size_t PlyValues::bytesLeft() const {
  return source_.bytes.size() - (isAscii() ? text_.offset() : offset_);
}

void PlyValues::requireEnd() {
  const bool atEnd =
      isAscii() ? text_.wordOfAnyLine().empty()
                : source_.bytes.find_first_not_of(" \t\r\n", offset_) == std::string_view::npos;
  if (!atEnd) throw error("the file goes on behind its last value: the header's counts are wrong");
}

InputError PlyValues::error(std::string_view what) const {
  return isAscii() ? text_.error(what) : source_.errorAtByte(offset_, what);
}

}  // namespace morphgrid
