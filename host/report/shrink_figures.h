#pragma once
#include <optional>
#include <string>
#include <vector>

#include "grid/shrink.h"

namespace morphgrid {

/// How much lateral struts have to shrink (computeShrinks()).
struct ShrinkCounts {
  double largestPercent = 0;
  int strutsOverLimit = 0;  ///< Struts that shrink by more than the material can.
  int strutsAtLimit = 0;    ///< Struts that shrink by as much as it can: there the limit binds.
  int strutsGrowing = 0;    ///< Struts that would have to grow, which no shrinking material does.
  double largestGrowthPercent = 0;
  int strutsUnderLeast = 0;  ///< Struts that shrink by less than the material does.
};

/// Counts for the whole grid, and for each layer from the bottom up.
struct ShrinkFigures : ShrinkCounts {
  std::vector<ShrinkCounts> layers;
};

/// Struts count as over the material's most, at it, under its least or growing beyond a millionth
/// of the printed length.
/// bounds: in the unit of the grid.
ShrinkFigures computeShrink(const StrutGrid& stacked, const ShrinkBounds& bounds);

/// How far lateral struts are from their rest lengths where the grid has come to rest.
struct StrainFigures {
  double largestPercent = 0;
  double meanPercent = 0;
  int strutsOverLimit = 0;  ///< Where there is a limit.
};

/// positions: 3 x vertexCount; limit: a share.
StrainFigures computeStrain(const StrutGrid& grid, const Eigen::Matrix3Xd& positions,
                            const std::optional<double>& limit);

/// What the material cannot do and what to do about it, a sentence each; none where it can.
std::vector<std::string> adviseOn(const ShrinkFigures& shrink, const ShrinkRange& range);
/// limit: a share.
std::vector<std::string> adviseOn(const StrainFigures& strain, double limit);

}  // namespace morphgrid
