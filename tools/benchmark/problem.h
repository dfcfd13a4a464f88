#pragma once
#include <string>

#include "app/scene.h"

namespace morphgrid {

/// A scene, measured and designed: what solvers are compared on.
struct Problem {
  std::string name;  ///< "egg_chair", "cup 200"
  GridDesign design;
  Weights weights;
  Scaling scaling;

  StrutGrid inPlane() const { return inPlaneGrid(design, weights, scaling); }
  /// printedLayer: where inPlane() comes to rest.
  StrutGrid stacked(const Eigen::Matrix3Xd& printedLayer) const {
    return stackedGrid(design, weights, scaling, printedLayer);
  }
};

/// nameOrFile: "egg_chair" for scenes/egg_chair.toml, or a path that ends in .toml. Throws
/// InputError when there is none.
Problem sceneProblem(const std::string& nameOrFile);

/// scenes/cup.toml with so many nodes on its long edge, its layers 0.35 struts apart.
Problem cupProblem(int nodesLong);

/// Three layers that want to bend into a saddle, without a design.
StrutGrid saddleGrid(int vertexCount);

}  // namespace morphgrid
