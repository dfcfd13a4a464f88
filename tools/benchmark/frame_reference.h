#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "grid/strut_grid.h"

namespace morphgrid {

/// The paper's weights of struts, which springs are compared with.
constexpr double kLateralWeight = 5;
constexpr double kVerticalWeight = 40;

/// A flat grid whose struts shrink, and where others than morphgrid say that it comes to rest: see
/// tests/solve/frames/README.md.
struct FrameReference {
  struct Answer {
    double thickness;              ///< Of the square bars, in mean lateral rest lengths.
    std::optional<double> energy;  ///< With E thickness^2 = 1, in the scene's units.
    Eigen::Matrix3Xd positions;    ///< 3 x vertexCount
  };

  std::string title;  ///< What it is, for tables.
  StrutGrid grid;     ///< As printed, of springs with the paper's weights.
  double poisson;
  std::vector<Answer> answers;

  double meanLateralRest() const;
  /// Throws InputError where there is none.
  const Answer& answerAt(double thickness) const;
};

/// Throws InputError when the file is not one.
FrameReference loadFrameReference(const std::filesystem::path& file);

/// The solids among the files of a folder, in alphabetical order.
std::vector<FrameReference> loadSolids(const std::filesystem::path& folder);

/// How the joints of a frame are taken.
struct JointModel {
  double radius;    ///< Of their rigid part, in widths of bars.
  bool isShearing;  ///< Whether bars shear (Timoshenko).
};
/// That of scenes, see applyMaterial().
constexpr JointModel kSceneJoint{.radius = 0.25, .isShearing = false};
/// Bars that reach to the joints' centres.
constexpr JointModel kPointJoint{.radius = 0, .isShearing = true};

/// The grid with its struts as square bars, printed where it starts; E width^2 = 1.
StrutGrid asFrame(StrutGrid grid, double width, double poisson, const JointModel& joint);

/// The grid with springs that stand for square bars (Model::bars), printed where it starts.
StrutGrid asSpringsForBars(StrutGrid grid, double width);

/// RMS and largest distance of points to others once the first are aligned rigidly, in percent of
/// the others' box's diagonal.
struct Mismatch {
  double rms, largest;
};
Mismatch mismatchOf(const Eigen::Matrix3Xd& points, const Eigen::Matrix3Xd& others);

/// RMS distance of points to others once the first are aligned rigidly; in their unit.
double alignedDistance(const Eigen::Matrix3Xd& points, const Eigen::Matrix3Xd& others);

/// The mirror image along u of positions, 3 x vertexCount: what a grid that is its own mirror image
/// may come to instead.
Eigen::Matrix3Xd twinOf(const GridShape& shape, const Eigen::Matrix3Xd& positions);

}  // namespace morphgrid
