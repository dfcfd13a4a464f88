#pragma once
#include <Eigen/Core>
#include <optional>
#include <string>

#include "render/camera.h"

namespace morphgrid {

/// In what a picture tells lengths.
struct LengthUnit {
  double perSceneUnit = 1;  ///< How many of them the scene's unit is, > 0.
  std::string name{};       ///< Of several, "mm"; may be empty.
  std::string nameOfOne{};  ///< Where it differs.

  /// "20 mm".
  std::string text(double length) const;
};

/// A round length as a picture shows it.
struct ScaleBar {
  double pixels;
  std::string text;
};

/// At the distance of `pivot`, at most `longest` pixels long; nothing where it is not seen. height:
/// of the picture, pixels.
std::optional<ScaleBar> scaleBarAt(const Camera& camera, const Eigen::Vector3d& pivot,
                                   double height, double longest, const LengthUnit& unit);

/// A round number, 1, 2 or 5 times a power of ten, at most `largest` > 0.
double roundLength(double largest);

}  // namespace morphgrid
