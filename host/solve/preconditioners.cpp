#include "solve/preconditioners.h"

#include <memory>

#include "energy/constant_matrix.h"
#include "solve/v_cycle.h"

namespace morphgrid {
namespace {

using Eigen::Matrix3Xd;

class RecordedCycle {
 public:
  RecordedCycle(const Device& device, const VertexVector& rightSide, const VertexVector& correction,
                const VCycle& cycle)
      : device_(device), rightSide_(rightSide), correction_(correction), stream_(device) {
    stream_.begin();
    cycle.record(stream_);
    stream_.end();
  }

  Matrix3Xd operator()(const Matrix3Xd& right) {
    rightSide_.upload(device_, right);
    stream_.submitAndWait();
    return correction_.download(device_);
  }

 private:
  const Device& device_;
  const VertexVector& rightSide_;
  const VertexVector& correction_;
  CommandStream stream_;
};

/// A cycle of its own.
struct OwnCycle {
  OwnCycle(const Device& device, const DeviceGrid& grid)
      : rightSide(device, grid.vectorLength()),
        correction(device, grid.vectorLength()),
        cycle(device, grid, rightSide, correction) {
    cycle.linearise(grid.positions());
  }

  VertexVector rightSide;
  VertexVector correction;
  VCycle cycle;
};

}  // namespace

Preconditioner vCyclePreconditioner(const Device& device, const VertexVector& rightSide,
                                    const VertexVector& correction, const VCycle& cycle) {
  return [recorded = std::make_shared<RecordedCycle>(device, rightSide, correction, cycle)](
             const Matrix3Xd& right) { return (*recorded)(right); };
}

Preconditioner vCyclePreconditioner(const Device& device, const DeviceGrid& grid) {
  const auto own = std::make_shared<OwnCycle>(device, grid);
  return [own, solve = vCyclePreconditioner(device, own->rightSide, own->correction, own->cycle)](
             const Matrix3Xd& right) { return solve(right); };
}

Preconditioner constantMatrixPreconditioner(const StrutGrid& grid) {
  return [matrix = std::make_shared<const ConstantMatrix>(grid)](const Matrix3Xd& right) {
    return matrix->solve(right);
  };
}

}  // namespace morphgrid
