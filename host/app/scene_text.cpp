#include "app/scene_text.h"

#include <filesystem>
#include <sstream>

namespace morphgrid {

std::string sceneText(TomlReader& reader) {
  toml::table whole = reader.document();
  whole.erase("extends");
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
