#include "app/scene_document.h"

#include <fmt/format.h>

#include "app/scene_keys.h"
#include "report/generated_block.h"
#include "surface/mesh_configuration_keys.h"

namespace morphgrid {

std::string withSceneKeys(std::string document) {
  const KeyDocument<Scene> scene(sceneKinds());
  for (const SceneKeySection& section : sceneKeys()) {
    const std::string where =
        section.name.empty() ? "the top level" : fmt::format("[{}]", section.name);
    document = withBlock(document, fmt::format("keys of {}", where), scene.table(section.keys));
  }
  const RecordKinds<MeshConfiguration> kinds{{}, [](std::size_t) { return MeshConfiguration(); }};
  return withBlock(document, "keys of mesh configurations",
                   KeyDocument<MeshConfiguration>(kinds).table(meshConfigurationKeys()));
}

}  // namespace morphgrid
