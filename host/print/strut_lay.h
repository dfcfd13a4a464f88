#pragma once
#include "grid/shrink.h"
#include "print/print_material.h"

namespace morphgrid {

/// How a strut between two hubs gets its shrink: in series. Part of the length between the hubs is
/// laid along it, the rest across it; the hubs take theirs. Shares of length lost are positive.
struct StrutLay {
  double along;        ///< What a length laid along loses, a share.
  double across;       ///< The same laid across, below `along`; below 0 it grows.
  double hub;          ///< What a hub's diameter loses.
  double hubDiameter;  ///< mm

  /// length: from vertex to vertex as printed, mm, above hubDiameter, as in what follows.
  double freeLength(double length) const { return length - hubDiameter; }
  /// What share of its length the strut can lose.
  ShrinkRange bounds(double length) const {
    return ShrinkBounds{{across, along}, hub, hubDiameter}.at(length);
  }
  /// What it loses when this share of its free length is laid along it.
  double shrinkAt(double share, double length) const {
    return (freeLength(length) * (share * along + (1 - share) * across) + hub * hubDiameter) /
           length;
  }
  /// The share that makes it lose this much; outside [0, 1] where none does.
  double shareFor(double shrink, double length) const {
    const double asked = (shrink * length - hub * hubDiameter) / freeLength(length);
    return (asked - across) / (along - across);
  }
};

StrutLay strutLayOf(const PrintMaterial& material, double hubDiameter);

/// The share that is laid for one that is asked for: in [0, 1], and neither part shorter than
/// kShortestZone unless it is not there. freeLength: mm, >= 2 kShortestZone.
double layableShare(double share, double freeLength);

/// The shortest part of a strut laid one way, mm: about two beads.
inline constexpr double kShortestZone = 1;

}  // namespace morphgrid
