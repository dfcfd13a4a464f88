#pragma once
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "core/cancellation.h"
#include "core/file_watch.h"
#include "core/view.h"
#include "measure/net.h"
#include "measure/surface_measurement.h"
#include "surface/closest_point.h"
#include "surface/mesh_sampling.h"
#include "target/mesh_figures.h"

namespace morphgrid {

/// Takes points from a target for one design, and keeps count. All functions throw Cancelled where
/// that is requested, and InputError where the target has no such points.
class TargetSampler {
 public:
  virtual ~TargetSampler() = default;

  /// The target's points at the net's vertices.
  virtual PointLattice points(const Net& net) = 0;

  /// Unit normals p_u x p_v at the net's vertices, 3 x (nodesU+1)(nodesV+1).
  virtual Eigen::Matrix3Xd normals(const Net& net) = 0;

  /// The second pass: one length and curvature for each chord between neighbouring points, which
  /// are those of the net. Curvatures are capped to curvatureLimit, in 1 / length.
  virtual SurfaceMeasurement measure(const Net& net, const PointLattice& points,
                                     double curvatureLimit) = 0;

  /// Figures of all rays cast at the target so far; nothing for targets without rays.
  virtual std::optional<MeshFigures> meshFigures() const { return std::nullopt; }
};

/// The surface that a grid is to become, loaded and surveyed. It does not change: threads may share
/// it. Its parameters (u, v) are in [0, 1]^2.
class Target {
 public:
  Target() = default;
  /// files: those that it is about to be loaded from.
  explicit Target(const std::vector<std::filesystem::path>& files) : files_(files) {}
  virtual ~Target() = default;
  Target(const Target&) = delete;
  Target& operator=(const Target&) = delete;

  /// What people should know of how it was loaded.
  virtual std::vector<std::string> notices() const { return {}; }

  /// The first pass: extents and curvature.
  virtual const SurfaceSurvey& survey() const = 0;

  /// The noise of the curvature, see LatticeSurvey; 1 / length. None for smooth surfaces.
  virtual std::optional<double> curvatureNoise() const { return std::nullopt; }

  /// A sampler for one design; it must not outlive the target.
  virtual std::unique_ptr<TargetSampler> sampler(const Cancellation& cancellation) const = 0;

  /// The closest points of the target; built at the first call, by one thread.
  const ClosestPointQuery& closestPoints() const;

  /// From where a grid that has become the target is seen best.
  virtual View view() const { return kPatchView; }

  /// The first pass of rays; null where none were cast.
  virtual const MeshSampling* meshSampling() const { return nullptr; }

  /// Whether the files that it was loaded from have changed on disk.
  bool isOutdated() const { return files_.hasChanged(); }

 private:
  virtual ClosestPointQuery makeClosestPoints() const = 0;

  FileWatch files_;
  mutable std::once_flag closestPointsMade_;
  mutable std::optional<ClosestPointQuery> closestPoints_;
};

}  // namespace morphgrid
