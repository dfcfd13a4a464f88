#pragma once
#include <filesystem>

#include "app/scene.h"
#include "gpu/device.h"

namespace morphgrid {

struct RunOptions {
  std::filesystem::path outputFolder;
  DeviceOptions device;
  bool quiet = false;  ///< No progress.
};

/// Reads nothing, solves nothing: measures and designs.
RunRecord checkScene(const Scene& scene);

/// The main job: measure, design, solve in the plane, stack, solve in space; leaves report,
/// pictures and files in the output folder. Throws InputError when the scene cannot be built or the
/// folder cannot be written, DeviceError when the device fails.
RunRecord runScene(const Scene& scene, const RunOptions& options);

}  // namespace morphgrid
