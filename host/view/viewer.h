#pragma once
#include <filesystem>
#include <optional>

#include "view/session.h"
#include "view/window.h"

namespace morphgrid {

struct ViewerOptions {
  std::filesystem::path pictureFile;  ///< Where the picture is saved to.
  /// Turns the scene and solves again and again for so many seconds, then prints how smoothly that
  /// went and closes.
  std::optional<double> statisticsSeconds;
};

/// Shows a session in a window until the user closes it or interrupts the program. Throws
/// DeviceError when the device fails, InputError when there is no font.
void runViewer(const Device& device, Window& window, Session& session,
               const ViewerOptions& options);

}  // namespace morphgrid
