#pragma once
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/scene.h"
#include "gpu/device.h"

namespace morphgrid {

/// A surface congruent, or similar, to another one, and how to come to it.
struct CongruentImage {
  std::string name;
  Scene (*of)(Scene scene);  ///< Of a scene of a Bezier patch.
};

/// The patch as it is first; then mirrored, its parameters reversed and swapped, 1000 times as
/// large, moved, turned.
const std::vector<CongruentImage>& congruentImages();

/// One design of a surface and of all that is congruent to it.
struct CongruenceResult {
  struct End {
    std::string image;
    bool converged;
    double rmsPercent;          ///< Of the morphed middle layer to its target.
    double energy;              ///< Over the square of the image's unit of length.
    std::string inverseEnding;  ///< Empty without inverse design.
  };
  std::string name;  ///< Of scene and design.
  std::vector<End> ends;

  /// The largest over the smallest, less 1; 0 where all are within what can be printed anyhow.
  double spread() const;
};

/// Designs and simulates images of a scene of a Bezier patch.
CongruenceResult congruenceOf(const std::shared_ptr<Device>& device, const std::string& name,
                              const Scene& scene,
                              const std::vector<CongruentImage>& images = congruentImages());

/// Five surfaces, each with the paper's design and with the one for the true shape, on coarse
/// grids; those whose `congruence: name` contains `only`. scenes: the folder of the scene files.
/// Prints a row for each when it is done; stops when the user interrupts.
std::vector<CongruenceResult> measureCongruence(const std::shared_ptr<Device>& device,
                                                const std::filesystem::path& scenes,
                                                const std::string& only);

/// What docs/robustness.md holds between its marks.
std::string toMarkdown(const std::vector<CongruenceResult>& results);

}  // namespace morphgrid
