#include "app/scene_text.h"

#include <filesystem>
#include <sstream>

#include "app/scene_keys.h"

namespace morphgrid {

std::string sceneText(TomlReader& reader) {
  toml::table whole = reader.document();
  whole.erase("extends");
  forEachFileKey([&](const auto& section, const auto& name, const FileKey<Scene>&) {
    if (const auto path = reader.section(section).path(name)) {
      std::error_code ignored;  // Without a current folder, paths stay as they are.
      const auto absolute = std::filesystem::absolute(*path, ignored).lexically_normal();
      whole[section].as_table()->insert_or_assign(name, absolute.string());
    }
  });
  std::ostringstream text;
  text << whole << '\n';
  return text.str();
}

}  // namespace morphgrid
