#include "app/scene_document.h"

#include <fmt/format.h>

#include "app/scene_keys.h"
#include "report/generated_block.h"
#include "surface/mesh_configuration_keys.h"
#include "surface/patch_keys.h"

namespace morphgrid {
namespace {

/// The table of a file that comes in one kind.
template <typename Record>
std::string tableOf(const std::vector<TomlKey<Record>>& keys) {
  const RecordKinds<Record> kinds{{}, [](std::size_t) { return Record(); }};
  return KeyDocument<Record>(kinds).table(keys);
}

}  // namespace

std::string withSceneKeys(std::string document) {
  const KeyDocument<Scene> scene(sceneKinds());
  for (const SceneKeySection& section : sceneKeys()) {
    const std::string where =
        section.name.empty() ? "the top level" : fmt::format("[{}]", section.name);
    document = withBlock(document, fmt::format("keys of {}", where), scene.table(section.keys));
  }
  document = withBlock(document, "keys of patch files", tableOf(patchKeys()));
  return withBlock(document, "keys of mesh configurations", tableOf(meshConfigurationKeys()));
}

}  // namespace morphgrid
