#include "print/print_file_kind.h"

#include <fmt/format.h>

#include <array>

#include "core/error.h"

namespace morphgrid {
namespace {

struct KindSigns {
  const char* what;
  std::array<const char*, 2> keys;  ///< Only such files have them.
};

// Printers and materials first, as PrintFileKind has them.
constexpr std::array<KindSigns, 3> kSigns{{{"a printer file", {"bed", "start"}},
                                           {"a material file", {"strut", "along"}},
                                           {"a scene", {"surface", "grid"}}}};

bool bears(const toml::table& document, const KindSigns& signs) {
  return document.contains(signs.keys[0]) || document.contains(signs.keys[1]);
}

}  // namespace

void requireKind(PrintFileKind kind, const std::filesystem::path& file,
                 const toml::table& document) {
  const KindSigns& asked = kSigns[static_cast<std::size_t>(kind)];
  if (bears(document, asked)) return;
  for (const KindSigns& signs : kSigns) {
    if (bears(document, signs)) {
      throw InputError(
          fmt::format("{}: is {}, where {} is due", file.string(), signs.what, asked.what));
    }
  }
}

}  // namespace morphgrid
