#pragma once
#include <vector>

#include "grid/grid_topology.h"

namespace morphgrid {

/// What forEachStrut() visits, for tests that compare it with another list.
inline std::vector<Strut> listStruts(const GridShape& shape) {
  std::vector<Strut> struts;
  forEachStrut(shape, [&](const Strut& strut) { struts.push_back(strut); });
  return struts;
}

}  // namespace morphgrid
