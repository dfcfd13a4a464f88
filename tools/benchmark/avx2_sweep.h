#pragma once
#include <cstddef>
#include <vector>

#include "grid/strut_grid.h"

namespace morphgrid {

/// One sweep of the jacobi method on the CPU, vectorised by hand for AVX2 on two threads: the speed
/// peer of shaders/solve/sweep.comp. Single precision, structure of arrays; every corner is
/// projected once, at its apex, and its pulls are scattered to the arms.
class Avx2Sweep {
 public:
  explicit Avx2Sweep(const StrutGrid& grid);

  static bool isSupported();

  /// `count` sweeps from the present state, the first without momentum, on this thread and one
  /// more.
  void run(int count);

  /// 3 x vertexCount, in the scene's unit of length.
  Eigen::Matrix3Xd positions() const;

 private:
  struct Fields {
    std::vector<float> x, y, z;
  };
  struct Window;

  std::size_t offset(int i, int j, int k) const;
  void sweepRows(int begin, int end, Window& window);
  void projectRow(int j, int k, Window& window);
  void updateRow(int j, int k, Window& window);
  void beginSweep(int sweep);

  GridShape shape_;
  double spacing_;
  float angleWeight_;
  Eigen::Vector3d origin_;
  int pitch_;  ///< Floats from one row to the next, with room for a vector before and after.
  Fields now_, next_;
  float momentum_ = 0;  ///< Momentum of the present sweep, as in chebyshevMomentum() of sweep.glsl.
  std::vector<float> restU_, restV_, restW_, stiffnessU_, stiffnessV_, stiffnessW_, stepPerForce_;
};

}  // namespace morphgrid
