#include "tests/solve/frame_grids.h"

#include <Eigen/Geometry>
#include <random>

#include "tests/solve/sample_grids.h"

namespace morphgrid {

StrutGrid welded(StrutGrid grid, const BarSize& size) {
  const double area = size.width * size.height;
  const double modulus = 2 * grid.stiffness.u.front() * grid.spacing / area;
  const BarSection section = rectangularSection(size, modulus);
  grid.bars = Bars{section, section, grid.positions};
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
