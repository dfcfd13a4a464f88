#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace morphgrid {

/// 64 bits of FNV-1a over what is added, in order: tells things apart, but is no
/// defence against forgery.
class Digest {
 public:
  /// The bytes as they are.
  Digest& add(std::string_view bytes);
  Digest& add(std::int64_t value);
  Digest& add(double value);
  /// Their count first, so that lists that follow each other are told apart.
  Digest& addList(std::string_view text);
  Digest& addList(std::span<const double> values);

  /// 16 hexadecimal digits.
  std::string text() const;

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325;
};

}  // namespace morphgrid
