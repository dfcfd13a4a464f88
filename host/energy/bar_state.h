#pragma once
#include "energy/frame_energy.h"

namespace morphgrid {

/// How a bar of a frame is loaded and bent.
struct BarState {
  // In stiffness x the square of the scene's unit of length; their sum is the bar's energy.
  double axialEnergy;
  double bendingEnergy;  ///< Of the mean curvature, in both planes.
  double shearEnergy;    ///< Of the shape of an S, which shear forces bring about, in both planes.
  double twistEnergy;
  /// By how much bending strains the outermost fibre, >= 0: at one of the bar's ends, along one of
  /// its edges.
  double bendingStrain;
  /// The chord rotation of structural mechanics: by how much a joint has turned the bar's end
  /// against its chord, rad; the larger one of both ends.
  double jointRotation;
};

/// Of a strut of a grid which has bars.
BarState barStateAt(const StrutGrid& grid, const FramePlacement& place, const Strut& strut);

}  // namespace morphgrid
