#include "target/mesh_target.h"

#include <fmt/format.h>

#include "core/number_range.h"
#include "measure/lattice_measurement.h"
#include "surface/load_mesh.h"
#include "surface/main_extent.h"
#include "surface/ray_hits.h"
#include "surface/subdivide_mesh.h"
#include "target/mesh_sampler.h"

namespace morphgrid {
namespace {

void requireWithinReach(const TriangleMesh& mesh) {
  const Eigen::AlignedBox3d box = boundingBox(mesh);
  for (const Eigen::Vector3d& corner : {box.min(), box.max()}) {
    for (const double coordinate : corner) {
      if (kCoordinates.contains(coordinate)) continue;
      throw InputError(fmt::format("each coordinate must be {} once transforms are done, got {}",
                                   describe(kCoordinates), coordinate));
    }
  }
}

class MeshTarget final : public Target {
 public:
  /// The file is watched from before place() loads it.
  template <typename Place>
  MeshTarget(const Place& place, const MeshRequest& request, const Cancellation& cancellation)
      : Target({request.configuration.mesh}),
        smoothingWidth_(request.smoothingWidth),
        placed_(place()),
        sampling_{placed_->mesh, {}} {
    figures_.secondsBuild = placed_->secondsBuild;
    figures_.file = request.configuration.mesh.string();
    figures_.triangles = static_cast<int>(sampling_.mesh.triangles.cols());
    figures_.extent = boundingBox(sampling_.mesh);
    figures_.suggestedBox =
        suggestBox(placed_->caster, placed_->extent, request.configuration.samplesU,
                   request.configuration.samplesV, request.steepestSlope, request.fillHoles);
    if (!request.box) {
      throw errorAt(request.boxPlace,
                    "surface.u_start, v_start, u_length and v_length are missing: the box that "
                    "rays sample; " +
                        adviseOnBox(figures_));
    }
    rays_ = {*request.box, request.fillHoles, request.steepestSlope};
    try {
      surveyBox(request.configuration, cancellation);
    } catch (const InputError& error) {
      throw errorAt(request.boxPlace, error.what());
    }
  }

  std::vector<std::string> notices() const override { return placed_->notices; }
  const SurfaceSurvey& survey() const override { return survey_.survey; }
  std::optional<double> curvatureNoise() const override { return survey_.curvatureNoise; }
  std::unique_ptr<TargetSampler> sampler(const Cancellation& cancellation) const override;
  View view() const override { return kMeshView; }
  const MeshSampling* meshSampling() const override { return &sampling_; }

 private:
  class Sampler;

  void surveyBox(const MeshConfiguration& configuration, const Cancellation& cancellation) {
    MeshSampler sampler(placed_->caster, rays_, figures_, cancellation);
    sampling_.hits = sampler.cast(configuration.samplesU, configuration.samplesV);
    figures_ = sampler.figures();
    survey_ = surveyLattice(sampling_.hits.lattice(), smoothingWidth_, cancellation);
  }

  ClosestPointQuery makeClosestPoints() const override {
    return {sampling_.mesh.vertices, sampling_.mesh.triangles};
  }

  double smoothingWidth_;
  std::shared_ptr<const PlacedMesh> placed_;
  MeshSampling sampling_;
  MeshFigures figures_;
  RaySettings rays_{};
  LatticeSurvey survey_{};
};

class MeshTarget::Sampler final : public TargetSampler {
 public:
  Sampler(const MeshTarget& target, const Cancellation& cancellation)
      : target_(target),
        cancellation_(cancellation),
        sampler_(target.placed_->caster, target.rays_, target.figures_, cancellation) {}

  /// Along the isolines in a lattice, whose holes can be filled from their own rim; what is too
  /// coarse for that, from the samples.
  PointLattice points(const Net& net) override {
    const int countU = net.nodesU + 1;
    const int countV = net.nodesV + 1;
    if (net.followsIsolines) {
      return sampler_.cast(countU, countV, target_.sampling_.hits).lattice();
    }
    return {countU, countV, sampler_.castThrough(net.parameters, target_.sampling_.hits)};
  }

  Eigen::Matrix3Xd normals(const Net& net) override {
    return sampler_.normals(net.parameters, target_.sampling_.hits);
  }

  SurfaceMeasurement measure(const Net& /*net*/, const PointLattice& points,
                             double curvatureLimit) override {
    return measureLattice(points, curvatureLimit, target_.smoothingWidth_, cancellation_);
  }

  std::optional<MeshFigures> meshFigures() const override { return sampler_.figures(); }

 private:
  const MeshTarget& target_;
  Cancellation cancellation_;
  MeshSampler sampler_;
};

std::unique_ptr<TargetSampler> MeshTarget::sampler(const Cancellation& cancellation) const {
  return std::make_unique<Sampler>(*this, cancellation);
}

}  // namespace

PlacedMesh::PlacedMesh(NotedMesh moved)
    : mesh(std::move(moved.mesh)),
      notices(std::move(moved.notices)),
      extent(mainExtent(mesh)),
      caster(addSeconds(secondsBuild, [&] { return MeshRayCaster(mesh); })) {}

std::shared_ptr<const PlacedMesh> placeMesh(const NotedMesh& loaded,
                                            const MeshConfiguration& configuration) {
  try {
    NotedMesh mesh = subdivideLoop(loaded.mesh, configuration.subdivisions);
    mesh.mesh = transformed(configuration.worldFromMesh, std::move(mesh.mesh));
    requireWithinReach(mesh.mesh);
    mesh.notices.insert(mesh.notices.begin(), loaded.notices.begin(), loaded.notices.end());
    for (std::string& notice : mesh.notices) {
      notice = fmt::format("{}: {}", configuration.mesh.string(), notice);
    }
    return std::make_shared<PlacedMesh>(std::move(mesh));
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", configuration.mesh.string(), error.what()));
  }
}

std::shared_ptr<const Target> makeMeshTarget(const std::shared_ptr<const PlacedMesh>& placed,
                                             const MeshRequest& request,
                                             const Cancellation& cancellation) {
  return std::make_shared<MeshTarget>([&] { return placed; }, request, cancellation);
}

std::shared_ptr<const Target> loadMeshTarget(const MeshRequest& request,
                                             const Cancellation& cancellation) {
  const MeshConfiguration& configuration = request.configuration;
  return std::make_shared<MeshTarget>(
      [&] { return placeMesh(loadMesh(configuration.mesh), configuration); }, request,
      cancellation);
}

}  // namespace morphgrid
