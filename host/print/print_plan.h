#pragma once
#include <string>
#include <vector>

#include "grid/strut_grid.h"
#include "print/bead.h"
#include "print/place_sheet.h"
#include "print/print_tools.h"
#include "print/strut_lay.h"

namespace morphgrid {

/// Of the polygons that stand for circles.
inline constexpr int kRingSides = 24;

/// Heights of the finished object and of what is printed for it, mm.
struct PrintHeights {
  double strut = 0;         ///< As printed.
  double strutSwollen = 0;  ///< The higher of both lays after the bath.
  double spacing = 0;       ///< tau: from tier to tier after the bath; 0 where there is one tier.
  double tube = 0;          ///< As printed.
};

/// A strut that the material cannot make as short, or as long, as the design wants.
struct StrutOutOfRange {
  Strut strut;
  double wanted;       ///< Shrink, a share.
  ShrinkRange bounds;  ///< What it can lose.

  double excess() const {
    return wanted > bounds.most ? wanted - bounds.most : bounds.least - wanted;
  }
};

/// What there is to tell of struts.
struct LayFigures {
  int struts = 0;
  double shortest = 0, median = 0, longest = 0;  ///< As printed, mm.
  int tooMuch = 0;                          ///< Struts that are asked to shrink more than they can.
  int tooLittle = 0;                        ///< The same of less.
  std::vector<StrutOutOfRange> outOfRange;  ///< The worst first.
  int rounded = 0;             ///< Struts whose zones were rounded to what can be laid.
  double largestRounding = 0;  ///< What that changed, a share of the printed length.
  double meanShareAcross = 0;  ///< Of free lengths.
};

/// A grid on its way to the printer: all of it in mm, on the bed.
struct PrintPlan {
  std::string name;
  Printer printer;
  PrintMaterial material;
  PrintRequest request;
  GridShape shape{};
  double scale = 0;
  double enlargement = 1;
  HubShape hub;
  PrintHeights heights;
  SheetPlacing placing;
  Eigen::Matrix2Xd positions;  ///< 2 x vertexCount, on the bed.
  StrutValues shareAlong;      ///< Of the free length of each lateral strut, as laid.
  StrutValues rest;            ///< What the laid grid morphs to, in the scene's unit.
  LayFigures figures;

  Bead strutBead(double height) const { return {printer.lineWidth, height}; }
  /// Of a strut as printed, mm.
  double strutWidth() const { return strutWidthOf(printer, material); }
  Eigen::Vector2d at(const GridPlace& place) const { return positions.col(shape.index(place)); }
};

/// What is printed of a grid as a run left it: positions as printed, rest lengths as designed. The
/// scale is the largest that fits unless it is asked for. The enlargement, to which the
/// equilibrium is indifferent, is 1 where that leaves no strut out of range, else that in
/// [0.8, 1.3] that leaves the fewest.
/// Throws InputError with every reason why it cannot be printed, one a line, and with what would
/// do.
PrintPlan planPrint(const std::string& name, const StrutGrid& grid, const Printer& printer,
                    const PrintMaterial& material, const PrintRequest& request);

}  // namespace morphgrid
