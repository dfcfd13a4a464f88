#include "solve/v_cycle.h"

namespace morphgrid {

VCycle::VCycle(const Device& device, const DeviceGrid& grid, const VertexVector& rightSide,
               const VertexVector& correction)
    : residual_(device, grid.vectorLength()),
      smoothed_(device, grid.vectorLength()),
      hessian_(makeHessian(device, grid)),
      coarse_(device, grid, hessian_->positions(), residual_.buffer(), smoothed_.buffer()),
      firstSmoothing_(hessian_->firstSmoothing(rightSide, smoothed_)),
      computeResidual_(hessian_->residual(smoothed_, rightSide, residual_)),
      lastSmoothing_(hessian_->smoothing(smoothed_, residual_, correction)),
      stream_(device) {}

void VCycle::linearise(const Buffer& positions, double damping) {
  hessian_->setDamping(damping);
  stream_.begin();
  hessian_->recordLinearisation(stream_, positions);
  stream_.end();
  stream_.submitAndWait();
  coarse_.build(damping);
}

void VCycle::record(CommandStream& stream) const {
  hessian_->record(stream, firstSmoothing_);
  hessian_->record(stream, computeResidual_);
  coarse_.recordCycle(stream);
  hessian_->record(stream, computeResidual_);
  hessian_->record(stream, lastSmoothing_);
}

}  // namespace morphgrid
