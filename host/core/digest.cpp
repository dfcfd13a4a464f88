#include "core/digest.h"

#include <fmt/format.h>

namespace morphgrid {
namespace {

template <typename Value>
std::string_view digestedBytes(std::span<const Value> values) {
  return {reinterpret_cast<const char*>(values.data()), values.size_bytes()};
}

}  // namespace

Digest& Digest::add(std::string_view bytes) {
  for (const char byte : bytes) {
    hash_ = (hash_ ^ static_cast<unsigned char>(byte)) * 0x100000001b3;
  }
  return *this;
}

Digest& Digest::add(std::int64_t value) {
  return add(digestedBytes(std::span<const std::int64_t>(&value, 1)));
}

Digest& Digest::add(double value) { return add(digestedBytes(std::span<const double>(&value, 1))); }

Digest& Digest::addList(std::string_view text) {
  return add(static_cast<std::int64_t>(text.size())).add(text);
}

Digest& Digest::addList(std::span<const double> values) {
  return add(static_cast<std::int64_t>(values.size())).add(digestedBytes(values));
}

std::string Digest::text() const { return fmt::format("{:016x}", hash_); }

}  // namespace morphgrid
