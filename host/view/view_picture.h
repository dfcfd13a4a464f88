#pragma once
#include <filesystem>

#include "view/draw_list.h"

namespace morphgrid {

/// Saves what a draw list shows as a PNG, drawn off screen as finely as can be, with caption and
/// legend. camera: for a picture of this aspect. Throws InputError when the file cannot be written
/// or there is no font.
void saveViewPicture(const std::filesystem::path& file, const Device& device, const DrawList& list,
                     const std::string& caption,
                     const std::function<Camera(double aspect)>& camera);

}  // namespace morphgrid
