#include "app/scene_text.h"

#include <sstream>

#include "core/toml_reader.h"

namespace morphgrid {

std::string sceneText(const std::filesystem::path& file, const toml::table& document) {
  toml::table whole = document;
  whole.erase("extends");
  TomlReader reader(file, document);
  TomlSection surface = reader.section("surface");
  for (const char* key : {"patch", "mesh"}) {
    if (const auto path = surface.path(key)) {
      std::error_code ignored;  // Without a current folder, paths stay as they are.
      const auto absolute = std::filesystem::absolute(*path, ignored).lexically_normal();
      whole["surface"].as_table()->insert_or_assign(key, absolute.string());
    }
  }
  std::ostringstream text;
  text << whole << '\n';
  return text.str();
}

}  // namespace morphgrid
