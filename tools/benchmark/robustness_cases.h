#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "design/build_grids.h"

namespace morphgrid {

/// One grid that the solver should cope with.
struct RobustnessCase {
  std::string group;
  std::string name;
  std::function<GridDesign()> design;  ///< Throws InputError where it cannot be printed.
  Weights weights = {};
  std::function<void(StrutGrid&)> disturb = {};  ///< The stacked grid; may be empty.
};

/// scenes: the folder of the scene files. Reads nothing yet.
std::vector<RobustnessCase> listRobustnessCases(const std::filesystem::path& scenes);

}  // namespace morphgrid
