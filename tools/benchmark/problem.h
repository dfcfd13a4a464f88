#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "app/scene.h"
#include "layout/conformal_sheet.h"

namespace morphgrid {

/// A scene, measured and designed: what solvers are compared on.
struct Problem {
  std::string name;  ///< "egg_chair", "cup 200"
  GridDesign design;
  Weights weights;
  Scaling scaling;
  std::optional<Sheet> sheet = {};  ///< Where the grid is laid out as one of bars.

  StrutGrid inPlane() const { return inPlaneGrid(design, weights, scaling); }
  /// printedLayer: where inPlane() comes to rest, or the sheet in space.
  StrutGrid stacked(const Eigen::Matrix3Xd& printedLayer) const {
    return stackedGrid(design, weights, scaling, printedLayer);
  }
};

/// Where the scenes, printers and materials of the project are.
std::filesystem::path checkoutFolder();

/// nameOrFile: as sceneProblem() takes it.
std::filesystem::path sceneFile(const std::string& nameOrFile);

/// nameOrFile: "egg_chair" for scenes/egg_chair.toml, or a path that ends in .toml. Throws
/// InputError when there is none.
Problem sceneProblem(const std::string& nameOrFile);

/// scenes/cup.toml with so many nodes on its long edge, its layers 0.35 struts apart.
Problem cupProblem(int nodesLong);
/// The same, on the sheet that a scene of bars has by default.
Problem weldedCupProblem(int nodesLong);

/// Three layers that want to bend into a saddle, without a design.
StrutGrid saddleGrid(int vertexCount);

}  // namespace morphgrid
