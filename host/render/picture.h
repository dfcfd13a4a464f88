#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "render/image.h"
#include "render/legend.h"
#include "render/scale_bar.h"

namespace morphgrid {

/// A picture is a scene with a footer: a caption on the left, a legend on the right.
struct PictureOptions {
  int width = 1280;     ///< Scene and footer, in pixels, >= kSmallestPicture
  int height = 960;     ///< Scene and footer, in pixels, >= kSmallestPicture
  std::string caption;  ///< UTF-8; on two lines where it must, then cut short.
  std::optional<Legend> legend;
  std::optional<ScaleBar> scaleBar;  ///< In the lower left corner of the scene.
  double lettersPerSide = 44;  ///< How many lines of text would be as high as the picture, > 0.
};

constexpr int kSmallestPicture = 64;

struct SceneSize {
  int width;
  int height;

  double aspect() const { return static_cast<double>(width) / height; }
};

/// What the footer leaves for the scene. The same with and without legend and caption, so that
/// pictures of one size can be laid over each other.
SceneSize sceneSize(const PictureOptions& options);

/// Adds the footer. scene: of sceneSize(options). Throws InputError that says what to install when
/// there is no font.
Image composePicture(const Image& scene, const PictureOptions& options);

/// Opaque. Throws InputError when the file cannot be written; one that was there is then kept.
void writePng(const std::filesystem::path& path, const Image& image);

}  // namespace morphgrid
