#include "tests/solve/frame_grids.h"

#include <Eigen/Geometry>
#include <random>
#include <utility>

#include "tests/solve/sample_grids.h"

namespace morphgrid {

StrutGrid welded(StrutGrid grid, const BarSize& size) {
  const double area = size.width * size.height;
  const double modulus = 2 * grid.stiffness.u.front() * grid.spacing / area;
  const BarSection section = rectangularSection(size, modulus);
  grid.bars = Bars{section, section, grid.positions};
  return grid;
}

StrutGrid weighedDown(StrutGrid grid, const Eigen::Vector3d& weightPerStiffness,
                      std::vector<int> held, bool slide) {
  JointLoads loads{Eigen::Matrix3Xd::Zero(3, grid.shape.vertexCount()), std::move(held), slide};
  forEachStrut(grid.shape, [&](const Strut& strut) {
    const Eigen::Vector3d half = grid.bars->section(strut).stretching *
                                 lengthAt(grid.bars->printed, strut) / 2 * weightPerStiffness;
    loads.forces.col(strut.from) += half;
    loads.forces.col(strut.to) += half;
  });
  grid.bars->loads = std::move(loads);
  return grid;
}

FramePlace shakenFrame(const StrutGrid& grid, double move, double turn, unsigned seed) {
  FramePlace place{shaken(grid.positions, move, seed), JointRotations(4, grid.shape.vertexCount())};
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> component(-turn, turn);
  for (Eigen::Index n = 0; n < place.rotations.cols(); ++n) {
    const Eigen::Vector3d axis(component(random), component(random), component(random));
    place.rotations.col(n) =
        Eigen::Quaterniond(Eigen::AngleAxisd(axis.norm(), axis.normalized())).coeffs();
  }
  return place;
}

}  // namespace morphgrid
