#pragma once
#include <filesystem>

#include "app/scene.h"
#include "gpu/device.h"
#include "print/print_record.h"

namespace morphgrid {

struct PrintOptions {
  std::filesystem::path outputFolder;
  std::vector<std::string> overrides;  ///< Of the keys of [print] of a finished run.
  std::optional<double> enlargement;   ///< See PrintRequest.
  bool isPlain = false;                ///< Without comments that name struts.
  DeviceOptions device;
  bool quiet = false;  ///< No progress.
};

struct PrintOutcome {
  PrintRecord record;
  RunRecord run;  ///< Of the design.
};

/// Designs and simulates a scene as runScene() does, and prints it: leaves G-code for each tier and
/// print.json in the output folder, all of them or none. What is laid is simulated once more.
/// Throws InputError when files cannot be read or written or the grid cannot be printed, otherwise
/// as runScene() does.
PrintOutcome printScene(Scene scene, const PrintOptions& options);

/// The same of a finished run. state: its file.
PrintOutcome printRun(const std::filesystem::path& state, const PrintOptions& options);

}  // namespace morphgrid
