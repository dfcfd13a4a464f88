#include "measure/conformal_map.h"

namespace morphgrid {

LatticeMap mapConformally(const PointLattice& lattice) {
  Eigen::Matrix3Xi triangles = triangulate(lattice);
  const Eigen::SparseMatrix<double> laplacian = cotangentLaplacian(lattice.points, triangles);
  return solveMap(lattice, std::move(triangles), laplacian, laplacian);
}

}  // namespace morphgrid
