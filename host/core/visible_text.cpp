#include "core/visible_text.h"

#include <fmt/format.h>

namespace morphgrid {
namespace {

bool isC0Control(unsigned char byte) { return byte < 0x20 || byte == 0x7f; }

/// U+0080 to U+009F, two bytes in UTF-8.
bool startsC1Control(std::string_view text) {
  return text.size() > 1 && text[0] == '\xc2' && static_cast<unsigned char>(text[1]) < 0xa0;
}

}  // namespace

std::string visibleText(std::string_view text, std::string_view kept) {
  std::string visible;
  for (std::size_t n = 0; n < text.size(); ++n) {
    const auto byte = static_cast<unsigned char>(text[n]);
    if (isC0Control(byte) && kept.find(text[n]) == std::string_view::npos) {
      visible += fmt::format("\\x{:02x}", byte);
    } else if (startsC1Control(text.substr(n))) {
      visible += fmt::format("\\x{:02x}", static_cast<unsigned char>(text[++n]));
    } else {
      visible += text[n];
    }
  }
  return visible;
}

}  // namespace morphgrid
