#include "surface/data_uri.h"

#include <charconv>
#include <cstdint>

#include "surface/mesh_source.h"

namespace morphgrid {
namespace {

constexpr std::string_view kScheme = "data:";

/// The six bits that a digit stands for; below 0 for what is none.
int sixBitsOf(char digit) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const std::size_t bits = kDigits.find(digit);
  return bits == std::string_view::npos ? -1 : static_cast<int>(bits);
}

/// Padding may be left out, and white space stand between.
std::optional<std::string> decodeBase64(std::string_view text) {
  const std::size_t last = text.find_last_not_of("= \t\r\n");
  text = text.substr(0, last == std::string_view::npos ? 0 : last + 1);
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3 + 3);
  std::uint32_t bits = 0;
  int count = 0;
  for (const char digit : text) {
    if (digit == ' ' || digit == '\t' || digit == '\r' || digit == '\n') continue;
    const int sixBits = sixBitsOf(digit);
    if (sixBits < 0) return std::nullopt;
    bits = bits << 6 | static_cast<std::uint32_t>(sixBits);
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes += static_cast<char>(bits >> count & 0xff);
  }
  if (count == 6) return std::nullopt;  // A digit alone holds no byte.
  return bytes;
}

}  // namespace

bool isDataUri(std::string_view uri) {
  return isSameWithoutCase(uri.substr(0, kScheme.size()), kScheme);
}

std::optional<std::string> decodeDataUri(std::string_view uri) {
  constexpr std::string_view kBase64 = ";base64";
  const std::size_t comma = uri.find(',');
  if (!isDataUri(uri) || comma == std::string_view::npos) return std::nullopt;
  const std::string_view before = uri.substr(0, comma);
  std::string content = decodePercent(uri.substr(comma + 1));
  const bool isBase64 = before.size() >= kBase64.size() &&
                        isSameWithoutCase(before.substr(before.size() - kBase64.size()), kBase64);
  return isBase64 ? decodeBase64(content) : std::optional(std::move(content));
}

std::string decodePercent(std::string_view text) {
  std::string result;
  result.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::string_view digits = text.substr(i + 1, text[i] == '%' ? 2 : 0);
    unsigned char byte = 0;
    const auto [end, problem] =
        std::from_chars(digits.data(), digits.data() + digits.size(), byte, 16);
    const bool isByte =
        problem == std::errc() && digits.size() == 2 && end == digits.data() + digits.size();
    result += isByte ? static_cast<char>(byte) : text[i];
    if (isByte) i += 2;
  }
  return result;
}

}  // namespace morphgrid
