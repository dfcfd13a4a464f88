#pragma once
#include <filesystem>

#include "app/output_files.h"
#include "app/simulate_scene.h"
#include "solve/morph_course.h"

namespace morphgrid {

/// What to make of the course of a morph; empty paths: not that.
struct FilmOptions {
  std::filesystem::path framesFolder;  ///< For frame_0000.png and so on.
  std::filesystem::path animation;     ///< A WebP file.
  std::filesystem::path gltf;          ///< A GLB file.
  int frameCount = 48;                 ///< The sheet as printed among them, 2 to kMostFrames.

  static constexpr int kMostFrames = 1000;

  bool wanted() const { return !framesFolder.empty() || !animation.empty() || !gltf.empty(); }
};

/// How the course went.
struct FilmRecord {
  bool converged = true;             ///< All steps.
  std::vector<std::string> notices;  ///< That it did not, or ends elsewhere than the simulation.
};

/// Follows the simulated scene's morph from the printed sheet and shows it, from one place that
/// sees all of it. The simulation's last stage must be one in space, and on the device. Throws
/// DeviceError when the device fails. quiet: no progress.
FilmRecord filmMorph(const Scene& scene, const SceneDesign& designed, const Device& device,
                     Simulation& simulation, const FilmOptions& options, OutputFiles& files,
                     bool quiet);

}  // namespace morphgrid
