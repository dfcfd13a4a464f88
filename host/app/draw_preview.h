#pragma once
#include <filesystem>
#include <vector>

#include "gpu/device.h"
#include "propose/sight.h"

namespace morphgrid {

/// A side of a mesh, as rays see it.
struct PreviewSide {
  Sight sight;
  std::optional<SamplingBox> box;  ///< Of the turned mesh; nothing where there is none.
  std::string caption;
};

/// Writes a sheet of pictures: the mesh from each side, with the box there and where rays in it
/// hit. Debris far away is cut off. Throws DeviceError when there is no device that draws,
/// InputError when the file cannot be written or there is no font.
void drawPreview(const std::filesystem::path& file, const std::string& title,
                 const TriangleMesh& mesh, const std::vector<PreviewSide>& sides,
                 const DeviceOptions& options = {});

/// The best sides, each with what it shows; at most as many as fit.
std::vector<PreviewSide> previewSides(const std::vector<SightRating>& sights);

}  // namespace morphgrid
