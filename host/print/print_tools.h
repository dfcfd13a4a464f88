#pragma once
#include <Eigen/Core>
#include <optional>
#include <vector>

#include "grid/shrink.h"
#include "print/bead.h"
#include "print/print_material.h"
#include "print/printer.h"

namespace morphgrid {

/// What the user decides. Lengths in mm.
struct PrintRequest {
  std::optional<double> scale;        ///< mm of the finished object per scene unit.
  std::optional<double> enlargement;  ///< The printed sheet over the run's, see planPrint().
  double pin = 1.75;                  ///< Diameter of what goes through hubs and tubes.
  double clearance = 0.2;             ///< By how much wider their holes are.
  int loops = 2;                      ///< Rings of a hub beside each other.
  std::optional<int> passes;          ///< Instead of the material's.

  bool operator==(const PrintRequest&) const = default;
};

/// With what a grid is printed, and how.
struct PrintTools {
  Printer printer;
  PrintMaterial material;
  PrintRequest request;

  bool operator==(const PrintTools&) const = default;
};

/// The rings at a vertex. Lengths in mm.
struct HubShape {
  double hole = 0;                ///< Diameter.
  double diameter = 0;            ///< Outer.
  std::vector<double> ringRadii;  ///< Of the beads' middles, the inner one first.
};

/// Hubs for these pins, of rings laid with this bead.
HubShape hubShapeOf(const PrintRequest& request, const Bead& ring);
/// With the passes that the request asks for.
PrintMaterial materialOf(const PrintTools& tools);
/// Of a strut as printed, mm.
double strutWidthOf(const Printer& printer, const PrintMaterial& material);

/// What a printed grid is to mechanics, mm: struts as wide as they are printed and as high as they
/// are after the bath, which tubes of the hubs' outer diameter join.
struct PrintedBars {
  double width;
  double height;
  double post;   ///< Side of the square that bends as a tube and its pin do.
  double joint;  ///< Radius of a hub.
};
PrintedBars printedBarsOf(const PrintTools& tools);

/// What struts can lose of a sheet that is printed at `scale` mm a unit; lengths in those units.
ShrinkBounds shrinkBoundsOf(const PrintTools& tools, double scale);

/// The largest scale, a round number of mm a unit, at which a sheet fits the bed. sheet: 2 x n with
/// n >= 1, as it is printed, in units. Throws InputError when not even a hub fits.
double largestScale(const PrintTools& tools, const Eigen::Matrix2Xd& sheet);

}  // namespace morphgrid
