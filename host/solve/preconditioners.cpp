#include "solve/preconditioners.h"

#include <memory>

#include "energy/constant_matrix.h"
#include "solve/v_cycle.h"

namespace morphgrid {
namespace {

using Eigen::Matrix3Xd;

class VCycleSolve {
 public:
  VCycleSolve(const Device& device, const DeviceGrid& grid)
      : device_(device),
        rightSide_(device, grid.shape().vertexCount()),
        correction_(device, grid.shape().vertexCount()),
        cycle_(device, grid, rightSide_, correction_),
        stream_(device) {
    cycle_.linearise(grid.positions());
    stream_.begin();
    cycle_.record(stream_);
    stream_.end();
  }

  Matrix3Xd operator()(const Matrix3Xd& right) {
    rightSide_.upload(device_, right);
    stream_.submitAndWait();
    return correction_.download(device_);
  }

 private:
  const Device& device_;
  VertexVector rightSide_;
  VertexVector correction_;
  VCycle cycle_;
  CommandStream stream_;
};

}  // namespace

Preconditioner vCyclePreconditioner(const Device& device, const DeviceGrid& grid) {
  return [solve = std::make_shared<VCycleSolve>(device, grid)](const Matrix3Xd& right) {
    return (*solve)(right);
  };
}

Preconditioner constantMatrixPreconditioner(const StrutGrid& grid) {
  return [matrix = std::make_shared<const ConstantMatrix>(grid)](const Matrix3Xd& right) {
    return matrix->solve(right);
  };
}

}  // namespace morphgrid
