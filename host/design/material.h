#pragma once
#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "grid/strut_grid.h"

namespace morphgrid {

/// What the struts are to the solver.
enum class Model {
  paper,  ///< Springs, and corners with weights that the scene chooses, as in the paper.
  bars,   ///< Springs that stand for bars: weighed by their size, corners rest as printed.
  frame,  ///< Bars that are welded to joints at the angles at which they were printed.
};
inline constexpr std::array kModelWords = {"paper", "bars", "frame"};
constexpr const char* nameOf(Model model) { return kModelWords[static_cast<std::size_t>(model)]; }
constexpr Mechanics mechanicsOf(Model model) {
  constexpr std::array kMechanics = {Mechanics::springs, Mechanics::springsAsPrinted,
                                     Mechanics::frame};
  return kMechanics[static_cast<std::size_t>(model)];
}

/// Joints of the bottom layer.
enum class SupportPlace { middle, corners, rim };
inline constexpr std::array kSupportWords = {"middle", "corners", "rim"};
/// Where a grid is held: there, or at the joint [i, j, k] along u, v and up.
using Support = std::variant<SupportPlace, std::array<int, 3>>;

/// What the struts are made of. Lengths in the scene's unit, > 0.
struct MaterialRequest {
  Model model = Model::paper;
  std::optional<double> barWidth;     ///< In the sheet's plane; a fifth of the mean rest length.
  std::optional<double> barHeight;    ///< Across it; as the width.
  std::optional<double> postWidth;    ///< Of square posts; as the width.
  std::optional<double> jointRadius;  ///< >= 0, of the rigid joint; a quarter of the width.
  double poisson = 0.3;               ///< >= 0 and < 0.5
  /// Share of its printed length that every strut loses at the least; below 0 it may grow.
  double leastShrinkage = 0;
  std::optional<std::array<double, 3>> gravity;  ///< m/s^2; z is up.
  std::optional<double> density;                 ///< Of bars, kg/m^3, > 0
  double fluidDensity = 0;                       ///< Of what is around them, >= 0
  std::optional<double> modulus;                 ///< Young's, of bars that morph; Pa, > 0
  double unit = 1e-3;                            ///< The scene's unit of length, m, > 0
  std::vector<Support> supports;
  bool slide = false;  ///< Whether they keep the height of joints alone.

  bool operator==(const MaterialRequest&) const = default;
};

/// As they are printed, where the mean rest length is `meanLength`.
struct BarSizes {
  double width, height, post, joint;
};
BarSizes barSizesOf(const MaterialRequest& material, double meanLength);
/// The same of a grid; nothing of Model::paper.
std::optional<BarSizes> barSizesOf(const StrutGrid& grid, const MaterialRequest& material);
/// With the sizes that it leaves out.
MaterialRequest withSizes(MaterialRequest material, double meanLength);

/// Makes of the struts of a stacked grid, at the positions where it is printed, what the model
/// says. The modulus makes EA of lateral bars twice the mean stiffness of springs times the mean
/// rest length, so that energies of all models are of one size. Bars do not shear: with rigid
/// joints of a quarter of their width that comes closest to solids (docs/method.md, A frame of
/// welded bars; Springs for bars). Supports hold the joints of bars, which weigh on them (see
/// joint_loads.h). Throws InputError when joints leave nothing of a strut, or a support is no joint
/// of the grid.
void applyMaterial(StrutGrid& grid, const MaterialRequest& material);

/// What cannot be printed of a welded grid, with the way out, for the user.
std::vector<std::string> adviseOnBars(const StrutGrid& grid, const MaterialRequest& material);

}  // namespace morphgrid
