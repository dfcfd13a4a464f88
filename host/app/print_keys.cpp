// What a scene says about its print.
#include "app/scene_keys.h"
#include "core/key_place.h"

namespace morphgrid {
namespace {

template <typename Value>
KeyPlace<Scene, Value> ofRequest(Value PrintRequest::*value) {
  const auto print = at(&Scene::print, &ScenePrint::tools);
  return {[=](const Scene& scene) -> const Value* {
            const PrintTools* tools = print.find(scene);
            return tools ? &(tools->request.*value) : nullptr;
          },
          [=](Scene& scene) -> Value* { return &(print.make(scene)->request.*value); }};
}

}  // namespace

SceneKeySection printKeys() {
  return {
      "print",
      {
          {.name = "printer",
           .value = fileKey(at(&Scene::print, &ScenePrint::printerFile), "printer file",
                            "(printers/ has some)"),
           .defaultInWords = "required, if there is a `[print]`",
           .meaning = "A printer file, see [printing_format.md](printing_format.md), relative to "
                      "this file."},
          {.name = "material",
           .value = fileKey(at(&Scene::print, &ScenePrint::materialFile), "material file",
                            "(materials/ has some)"),
           .defaultInWords = "required, if there is a `[print]`",
           .meaning = "A material file, alike. What its struts can lose, each by its length, takes "
                      "the place of `grid.max_shrinkage` and `material.least_shrinkage`; bars are "
                      "as wide and high as they are printed where `[material]` does not say it."},
          {.name = "scale",
           .value = numberKey(ofRequest(&PrintRequest::scale), fromTo(1e-6, 1e6)),
           .unit = "mm / length",
           .defaultInWords = "the largest that fits the bed",
           .knob = aroundItsValue("print scale"),
           .meaning = "mm of the finished object per unit of the scene."},
          {.name = "pin",
           .value = numberKey(ofRequest(&PrintRequest::pin), fromTo(0.2, 20)),
           .unit = "mm",
           .defaultInWords = "1.75, filament",
           .meaning = "Diameter of the pins through hubs and tubes."},
          {.name = "clearance",
           .value = numberKey(ofRequest(&PrintRequest::clearance), fromTo(0, 5)),
           .unit = "mm",
           .defaultInWords = "0.2",
           .meaning = "By how much wider their holes are."},
          {.name = "loops",
           .value = integerKey(ofRequest(&PrintRequest::loops), {1, 10}),
           .defaultInWords = "2",
           .meaning = "Rings of a hub beside each other. Smaller hubs leave struts more of their "
                      "range."},
          {.name = "passes",
           .value = integerKey(ofRequest(&PrintRequest::passes), {1, 1000}),
           .defaultInWords = "the material's",
           .meaning = "Of a strut, on top of each other."},
      }};
}

}  // namespace morphgrid
