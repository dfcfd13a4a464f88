#include "target/patch_target.h"

#include "grid/surface_mesh.h"
#include "measure/lattice_measurement.h"

namespace morphgrid {
namespace {

/// Along u and v, of the triangles that stand for the surface in closest-point queries: their
/// sagitta is then far below the distances that are reported.
constexpr int kClosestCells = 400;

class PatchSampler final : public TargetSampler {
 public:
  PatchSampler(const BezierPatch& patch, Cancellation cancellation)
      : patch_(patch), cancellation_(std::move(cancellation)) {}

  PointLattice points(const Net& net) override {
    cancellation_.check();
    return {net.nodesU + 1, net.nodesV + 1, pointsAt(patch_, net.parameters)};
  }

  Eigen::Matrix3Xd normals(const Net& net) override { return normalsAt(patch_, net.parameters); }

  /// The patch knows how its isolines curve; other lines are splines through their points.
  SurfaceMeasurement measure(const Net& net, const PointLattice& points,
                             double curvatureLimit) override {
    return net.followsIsolines
               ? measureSurface(patch_, net.nodesU, net.nodesV, curvatureLimit, cancellation_)
               : measureLattice(points, curvatureLimit, 0, cancellation_);
  }

 private:
  const BezierPatch& patch_;
  Cancellation cancellation_;
};

class PatchTarget final : public Target {
 public:
  PatchTarget(const PatchRequest& request, const Cancellation& cancellation)
      : patch_(request.controlPoints), survey_(surveySurface(patch_, cancellation)) {}

  const SurfaceSurvey& survey() const override { return survey_; }

  std::unique_ptr<TargetSampler> sampler(const Cancellation& cancellation) const override {
    return std::make_unique<PatchSampler>(patch_, cancellation);
  }

 private:
  ClosestPointQuery makeClosestPoints() const override { return closestPointsOf(patch_); }

  BezierPatch patch_;
  SurfaceSurvey survey_;
};

}  // namespace

std::shared_ptr<const Target> makePatchTarget(const PatchRequest& request,
                                              const Cancellation& cancellation) {
  try {
    return std::make_shared<PatchTarget>(request, cancellation);
  } catch (const InputError& error) {
    throw errorAt(request.place, error.what());
  }
}

ClosestPointQuery closestPointsOf(const Surface& surface) {
  const Net net = isolineNet(kClosestCells, kClosestCells);
  return {pointsAt(surface, net.parameters), latticeTriangles(net.shape())};
}

}  // namespace morphgrid
