#include "app/try_design.h"

#include "app/design_scene.h"
#include "core/error.h"

namespace morphgrid {

DesignTrial tryDesign(const MeshRequest& surface, const std::shared_ptr<const Target>& target,
                      const DesignRequest& design, const MaterialRequest& material) {
  Scene scene{.name = "proposal", .file = surface.configuration.mesh};
  scene.surface = surface;
  scene.design = design;
  scene.material = material;
  try {
    const SceneDesign designed = designScene(scene, target);
    DesignTrial trial;
    if (designed.sheet) trial.sheet = designed.sheet->figures;
    if (designed.net) trial.net = designed.net->quality;
    return trial;
  } catch (const InputError& error) {
    return {.failure = error.what()};
  }
}

}  // namespace morphgrid
