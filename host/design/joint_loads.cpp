#include "design/joint_loads.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/error.h"

namespace morphgrid {
namespace {

constexpr double kInLine = 1e-6;

/// A bar's weight over its EA and its printed length: then neither the solver's unit of force nor
/// the cross-section matters. In the scene's unit of length^-1.
Eigen::Vector3d weightPerStiffness(const MaterialRequest& material) {
  if (!material.gravity) {
    return Eigen::Vector3d::Zero();
  }
  return (*material.density - material.fluidDensity) * material.unit / *material.modulus *
         Eigen::Vector3d(material.gravity->data());
}

Eigen::Matrix3Xd weightsOfBars(const StrutGrid& grid, const MaterialRequest& material) {
  const Eigen::Vector3d perStiffness = weightPerStiffness(material);
  const Bars& bars = *grid.bars;
  Eigen::Matrix3Xd forces = Eigen::Matrix3Xd::Zero(3, grid.shape.vertexCount());
  forEachStrut(grid.shape, [&](const Strut& strut) {
    const Eigen::Vector3d half =
        bars.section(strut).stretching * lengthAt(bars.printed, strut) / 2 * perStiffness;
    forces.col(strut.from) += half;
    forces.col(strut.to) += half;
  });
  return forces;
}

class SupportedJoints {
 public:
  explicit SupportedJoints(const GridShape& shape) : shape_(shape) {}

  void operator()(SupportPlace place) {
    forEachVertex(shape_.layer(), [&](const GridPlace& at) {
      if (isAt(place, at)) joints_.push_back(shape_.index(at));
    });
  }

  void operator()(const std::array<int, 3>& joint) {
    const auto [i, j, k] = joint;
    if (i >= shape_.verticesU || j >= shape_.verticesV || k >= shape_.layers) {
      throw InputError(fmt::format(
          "material.supports must be joints [i, j, k] from [0, 0, 0] to [{}, {}, {}], got [{}, {}, "
          "{}]",
          shape_.verticesU - 1, shape_.verticesV - 1, shape_.layers - 1, i, j, k));
    }
    joints_.push_back(shape_.index(i, j, k));
  }

  std::vector<int> sorted() && {
    std::sort(joints_.begin(), joints_.end());
    joints_.erase(std::unique(joints_.begin(), joints_.end()), joints_.end());
    return std::move(joints_);
  }

 private:
  bool isAt(SupportPlace place, const GridPlace& at) const {
    if (place == SupportPlace::middle) {
      return at.i == shape_.verticesU / 2 && at.j == shape_.verticesV / 2;
    }
    const bool isFirstOrLastU = at.i == 0 || at.i == shape_.verticesU - 1;
    const bool isFirstOrLastV = at.j == 0 || at.j == shape_.verticesV - 1;
    return place == SupportPlace::corners ? isFirstOrLastU && isFirstOrLastV
                                          : isFirstOrLastU || isFirstOrLastV;
  }

  GridShape shape_;
  std::vector<int> joints_;
};

/// supports: 3 x n, as printed.
void requireThatItStands(const Eigen::Matrix3Xd& supports) {
  const Eigen::Matrix2Xd offsets =
      supports.topRows<2>().colwise() - supports.topRows<2>().rowwise().mean();
  const Eigen::Matrix2d spread = offsets * offsets.transpose();
  const Eigen::Vector2d extents =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(spread).eigenvalues();
  if (extents[0] <= kInLine * kInLine * extents[1]) {
    throw InputError(
        "material.slide needs three material.supports that are not in line: on fewer the grid "
        "tips over");
  }
}

}  // namespace

std::optional<JointLoads> jointLoads(const StrutGrid& welded, const MaterialRequest& material) {
  if (material.supports.empty()) {
    return std::nullopt;
  }
  SupportedJoints joints(welded.shape);
  for (const Support& support : material.supports) {
    std::visit(joints, support);
  }
  JointLoads loads{weightsOfBars(welded, material), std::move(joints).sorted(), material.slide};
  if (loads.slide) {
    requireThatItStands(welded.bars->printed(Eigen::all, loads.held));
  }
  return loads;
}

bool holdApart(const JointLoads& loads, const GridShape& shape) {
  return !loads.slide && std::any_of(loads.held.begin(), loads.held.end(), [&](int joint) {
    return shape.column(joint) != shape.column(loads.held.front());
  });
}

double weightInNewtons(const StrutGrid& loaded, const MaterialRequest& material) {
  const BarSection& bar = loaded.bars->lateral;
  const double area = 12 * std::sqrt(bar.bendingN * bar.bendingB) / bar.stretching;
  const double newtonsPerForce =
      *material.modulus * area * material.unit * material.unit / bar.stretching;
  return newtonsPerForce * loaded.bars->loads->forces.rowwise().sum().norm();
}

}  // namespace morphgrid
