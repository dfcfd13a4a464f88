#include "app/stagehands.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/solve_room.h"

namespace morphgrid {

void Stagehands::requireSilence() const {
  if (device && !failure && !device->validationMessages().empty()) {
    throw DeviceError(fmt::format("the validation layers complain:\n{}",
                                  fmt::join(device->validationMessages(), "\n")));
  }
}

Stagehands summonStagehands(const Scene& scene, const SceneDesign& designed,
                            const DeviceOptions& device, const PictureOptions& picture,
                            ShowPanel show) {
  Stagehands hands;
  if (scene.method != Method::reference || scene.pictures.enabled) {
    hands.device = std::make_unique<Device>(device);
    const GridDesign& design = designed.design;
    const GridShape shape{design.nodesU + 1, design.nodesV + 1, design.layers};
    if (const auto reason = whyTooLarge(shape, scene.method, roomOn(*hands.device))) {
      throw InputError(fmt::format("{}: {}", scene.file.string(), *reason));
    }
  }
  if (scene.pictures.enabled) {
    hands.pictures = std::make_unique<Pictures>(*hands.device, picture, std::move(show),
                                                scene.mesh ? kMeshView : kPatchView);
  }
  return hands;
}

}  // namespace morphgrid
