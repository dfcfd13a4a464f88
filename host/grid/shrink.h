#pragma once
#include <algorithm>

#include "grid/strut_grid.h"

namespace morphgrid {

/// What share of its printed length a material can make a strut lose; below 0 it grows.
struct ShrinkRange {
  double least = 0;
  double most = 0.4;  ///< Above `least`, below 1.

  bool operator==(const ShrinkRange&) const = default;
};

/// What a strut can lose by the length at which it is printed: between the hubs at its ends the
/// material's range, of the hubs themselves a share that nobody chooses. Lengths in one unit.
struct ShrinkBounds {
  ShrinkRange material;
  double hub = 0;          ///< What a hub's diameter loses, a share.
  double hubDiameter = 0;  ///< Half of it at either end of a strut, >= 0; 0: no hubs.

  /// Of a strut of this length from vertex to vertex, > 0. One that is shorter than a hub loses
  /// what hubs do.
  ShrinkRange at(double printed) const {
    const double share = std::min(1.0, hubDiameter / printed);
    return {material.least + share * (hub - material.least),
            material.most + share * (hub - material.most)};
  }
  /// The length at which a strut comes to be `rest` long when it loses the least it can.
  double shortestFor(double rest) const { return printedAs(rest, material.least); }
  /// The same when it loses the most.
  double longestFor(double rest) const { return printedAs(rest, material.most); }

  bool operator==(const ShrinkBounds&) const = default;

 private:
  double printedAs(double rest, double loss) const {
    return std::max(hubDiameter, (rest + (hub - loss) * hubDiameter) / (1 - loss));
  }
};

/// What share of its printed length each strut has to lose: 1 - L / printed, the printed length
/// being that of grid.positions, where the stage starts. Below 0 where it would have to grow.
StrutValues computeShrinks(const StrutGrid& grid);

/// The same over the most that lateral struts can lose; of posts, over what the material can.
StrutValues computeShrinkShares(const StrutGrid& grid, const ShrinkBounds& bounds);

}  // namespace morphgrid
