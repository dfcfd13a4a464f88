#pragma once
#include <filesystem>
#include <optional>

#include "print/print_tools.h"
#include "print/print_verdict.h"

namespace morphgrid {

struct Scene;
struct MaterialRequest;

/// With what a scene is to be printed: its section [print].
struct ScenePrint {
  std::filesystem::path printerFile;
  std::filesystem::path materialFile;
  PrintTools tools;  ///< As the files have them.

  bool operator==(const ScenePrint&) const = default;
};

// What a print means for a design. mmPerUnit: the scale at which it is printed; nothing where the
// scene has no [print], or its sheet is not known yet. Lengths are the scene's.

/// What the scene's material does to struts.
ShrinkBounds shrinkBoundsOf(const Scene& scene, const std::optional<double>& mmPerUnit);

/// The scene's material, with the sizes of bars that are printed where it leaves them out.
MaterialRequest materialOf(const Scene& scene, const std::optional<double>& mmPerUnit);

/// How thick struts are for what comes close to them.
std::optional<double> strutThicknessOf(const Scene& scene, const std::optional<double>& mmPerUnit);

/// What a design of this scene knows of its print.
DesignBounds designBoundsOf(const Scene& scene);

/// The scene's own scale, else the largest at which the sheet fits the bed; nothing without
/// [print]. sheet: 2 x n as printed. Throws InputError as largestScale().
std::optional<double> mmPerUnitOf(const Scene& scene, const Eigen::Matrix2Xd& sheet);

}  // namespace morphgrid
