#include "app/run_context.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/device_capacity.h"
#include "gpu/slow_compile.h"

namespace morphgrid {

void RunContext::requireSilence() const {
  if (device && !failure && !device->validationMessages().empty()) {
    throw DeviceError(fmt::format("the validation layers complain:\n{}",
                                  fmt::join(device->validationMessages(), "\n")));
  }
}

void sayWhenCompiling(const Device& device) {
  tellSlowCompile(device, [name = device.name()] {
    fmt::print(stderr, "compiling kernels for {}: the driver keeps them for the next time\n", name);
  });
}

std::shared_ptr<Device> deviceFor(const Scene& scene, const DeviceOptions& options, bool quiet) {
  if (scene.method == Method::reference && !scene.pictures.enabled) return nullptr;
  auto device = std::make_shared<Device>(options);
  if (!quiet) sayWhenCompiling(*device);
  return device;
}

RequireShape roomOn(std::shared_ptr<const Device> device, const Scene& scene) {
  return [device = std::move(device), &scene](const GridShape& shape) {
    if (!device) return;
    if (const auto reason = explainOverflow(shape, workloadOf(scene), capacityOf(*device))) {
      throw InputError(*reason);  // designScene() names the scene.
    }
  };
}

RunContext createRunContext(const Scene& scene, const SceneDesign& designed,
                            std::shared_ptr<Device> device, const PictureOptions& picture,
                            ShowPanel show) {
  RunContext context;
  context.device = std::move(device);
  if (scene.pictures.enabled) {
    context.pictures =
        std::make_unique<Pictures>(*context.device, picture, std::move(show), designed.view());
  }
  return context;
}

}  // namespace morphgrid
