#pragma once
#include <filesystem>

#include "app/checkpoint_keeper.h"
#include "app/output_files.h"
#include "app/simulate_scene.h"
#include "gpu/device.h"

namespace morphgrid {

struct RunOptions {
  std::filesystem::path outputFolder;
  DeviceOptions device;
  bool quiet = false;  ///< No progress.
  CheckpointOptions checkpoint;
  std::filesystem::path resumeFrom;  ///< A checkpoint; empty: the run starts anew.
};

/// Writes the chosen files of a result, the smallest first. targets: see SceneDesign.
void exportFiles(const Simulation& result, const std::optional<Eigen::Matrix3Xd>& targets,
                 const FileChoices& choices, OutputFiles& files);

/// Reads nothing, solves nothing: measures and designs.
RunRecord checkScene(const Scene& scene);

/// Adds a notice when the first device that will do cannot hold the checked scene's grid.
void noteInsufficientDevice(const Scene& scene, RunRecord& record);

/// The main job: measure, design, solve in the plane, stack, solve in space; leaves report, state,
/// files for other programs and pictures in the output folder, in this order. What cannot be
/// written is in RunRecord::lostFiles. When the device fails on the way, the record and the files
/// hold what was done so far, without pictures. Ctrl-C ends it at once while there is nothing to
/// save; a solve stops and leaves what there is. Throws InputError when the scene cannot
/// be built, the folder or checkpoint cannot be written or the checkpoint to resume from will not
/// do, DeviceError when there is no device that will do, Cancelled when the user has asked to stop
/// before anything was solved.
RunRecord runScene(const Scene& scene, const RunOptions& options);

}  // namespace morphgrid
