#include "app/run_context.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/device_capacity.h"

namespace morphgrid {

void RunContext::requireSilence() const {
  if (device && !failure && !device->validationMessages().empty()) {
    throw DeviceError(fmt::format("the validation layers complain:\n{}",
                                  fmt::join(device->validationMessages(), "\n")));
  }
}

RunContext createRunContext(const Scene& scene, const SceneDesign& designed,
                            const DeviceOptions& device, const PictureOptions& picture,
                            ShowPanel show) {
  RunContext context;
  if (scene.method != Method::reference || scene.pictures.enabled) {
    context.device = std::make_unique<Device>(device);
    const GridDesign& design = designed.design;
    const GridShape shape{design.nodesU + 1, design.nodesV + 1, design.layers};
    if (const auto reason =
            explainOverflow(shape, workloadOf(scene), capacityOf(*context.device))) {
      throw InputError(fmt::format("{}: {}", scene.file.string(), *reason));
    }
  }
  if (scene.pictures.enabled) {
    context.pictures =
        std::make_unique<Pictures>(*context.device, picture, std::move(show), designed.view());
  }
  return context;
}

}  // namespace morphgrid
