#include "surface/mesh_ray_caster.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <span>

#include "surface/embree_mesh.h"

namespace morphgrid {
namespace {

using Eigen::Index;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int kPacket = 8;
// Rays between two looks at whether to go on.
constexpr std::size_t kRaysPerCheck = 1024 * kPacket;

/// How far beside the mesh a ray still counts as on its boundary, in halves of the mesh's extent.
constexpr double kReach = 2e-6;

/// The place itself; then around it, for rays on the mesh's boundary that rounding to single
/// precision has put beside it. Of eight directions one leads into any corner of 45 degrees.
constexpr std::array<std::array<double, 2>, 9> kOffsets{
    {{0, 0}, {1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {1, -1}, {-1, 1}, {-1, -1}}};

/// Rays lean by this much, far below rounding: along a slope of 0 Embree finds what begins at the
/// ray, but not what ends at it. Four ways of leaning find both, along y and z.
constexpr float kLean = 1e-15F;
constexpr std::array<std::array<float, 2>, 4> kLeanings{
    {{kLean, kLean}, {kLean, -kLean}, {-kLean, kLean}, {-kLean, -kLean}}};

/// x where the line along x through a place meets the plane of a triangle, whose corners are the
/// columns; within the triangle's own x, give or take the reach, where the triangle is edge-on.
double xOnTriangle(const Eigen::Matrix3d& corners, const Vector2d& place, double reach) {
  const Vector3d corner = corners.col(0);
  const Vector3d normal = (corners.col(1) - corner).cross(corners.col(2) - corner);
  const double x = corner.x() - normal.tail<2>().dot(place - corner.tail<2>()) / normal.x();
  const double first = corners.row(0).minCoeff() - reach;
  const double last = corners.row(0).maxCoeff() + reach;
  return x >= first ? std::min(x, last) : first;  // 0 / 0 too goes to the side that rays meet.
}

}  // namespace

/// From the mesh's box to the cube from -1 to 1: in it, single precision does as well for a mesh
/// that is tiny, flat or far from the origin.
struct Normalisation {
  Vector3d center;
  Vector3d halfExtent;  ///< > 0

  explicit Normalisation(const Eigen::AlignedBox3d& box)
      : center(box.center()),
        halfExtent((box.sizes().array() > 0).select(box.sizes() / 2, Vector3d::Ones())) {}

  Eigen::Matrix3Xf vertices(const Eigen::Matrix3Xd& world) const {
    return ((world.colwise() - center).array().colwise() / halfExtent.array()).cast<float>();
  }
  Vector2d place(const Vector2d& world) const {
    return (world - center.tail<2>()).cwiseQuotient(halfExtent.tail<2>());
  }
};

struct MeshRayCaster::Scene {
  TriangleMesh mesh;
  Normalisation normalisation;
  EmbreeMesh embree;

  explicit Scene(const TriangleMesh& source)
      : mesh(source),
        normalisation(boundingBox(mesh)),
        embree(normalisation.vertices(mesh.vertices), mesh.triangles, RTC_SCENE_FLAG_ROBUST,
               RTC_BUILD_QUALITY_MEDIUM) {}

  std::vector<Index> withinReach(const Eigen::Matrix2Xd& places) const;
  void castPacket(std::span<const Index> rays, const Vector2d& offset,
                  Eigen::Matrix3Xd& points) const;
};

/// The places that a ray can hit at all.
std::vector<Index> MeshRayCaster::Scene::withinReach(const Eigen::Matrix2Xd& places) const {
  std::vector<Index> within;
  for (Index n = 0; n < places.cols(); ++n) {
    const Vector2d place = normalisation.place(places.col(n));
    if ((place.array().abs() <= 1 + 2 * kReach).all()) {
      within.push_back(n);
    }
  }
  return within;
}

/// Casts up to kPacket rays, moved by the offset (in halves of the extent), and sets x of those
/// points that are hit.
void MeshRayCaster::Scene::castPacket(std::span<const Index> rays, const Vector2d& offset,
                                      Eigen::Matrix3Xd& points) const {
  alignas(32) std::array<int, kPacket> valid{};
  RTCRayHit8 packet{};
  for (std::size_t lane = 0; lane < rays.size(); ++lane) {
    const Eigen::Vector2f place =
        (normalisation.place(points.col(rays[lane]).tail<2>()) + offset).cast<float>();
    valid[lane] = -1;
    packet.ray.org_x[lane] = -2;  // The mesh begins at -1.
    packet.ray.org_y[lane] = place.x();
    packet.ray.org_z[lane] = place.y();
    packet.ray.dir_x[lane] = 1;
    packet.ray.tfar[lane] = std::numeric_limits<float>::infinity();
    packet.ray.mask[lane] = ~0U;
    packet.hit.geomID[lane] = RTC_INVALID_GEOMETRY_ID;
  }
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  for (const auto& [y, z] : kLeanings) {  // A hit shortens the ray: the nearest remains.
    std::fill_n(packet.ray.dir_y, kPacket, y);
    std::fill_n(packet.ray.dir_z, kPacket, z);
    rtcIntersect8(valid.data(), embree.scene(), &context, &packet);
  }
  for (std::size_t lane = 0; lane < rays.size(); ++lane) {
    if (packet.hit.geomID[lane] != RTC_INVALID_GEOMETRY_ID) {
      auto point = points.col(rays[lane]);
      const auto corners = mesh.triangles.col(packet.hit.primID[lane]);
      point.x() = xOnTriangle(mesh.vertices(Eigen::all, corners), point.tail<2>(),
                              kReach * normalisation.halfExtent.x());
    }
  }
}

MeshRayCaster::MeshRayCaster(const TriangleMesh& mesh) : scene_(std::make_unique<Scene>(mesh)) {}

MeshRayCaster::~MeshRayCaster() = default;
MeshRayCaster::MeshRayCaster(MeshRayCaster&&) noexcept = default;
MeshRayCaster& MeshRayCaster::operator=(MeshRayCaster&&) noexcept = default;

RayHits MeshRayCaster::cast(const SamplingBox& box, int countU, int countV,
                            const Cancellation& cancellation) const {
  assert(countU >= 2 && countV >= 2 && box.uLength > 0 && box.vLength > 0);
  RayHits hits{box, countU, countV, {}, {}};
  Eigen::Matrix2Xd places(2, Index(countU) * countV);
  for (int j = 0; j < countV; ++j) {
    for (int i = 0; i < countU; ++i) {
      places.col(hits.index(i, j)) << hits.u(i), hits.v(j);
    }
  }
  hits.points = castThrough(places, cancellation);
  for (double& x : hits.points.row(0)) {
    hits.hit.push_back(!std::isnan(x));
    x = std::isnan(x) ? 0 : x;
  }
  return hits;
}

Eigen::Matrix3Xd MeshRayCaster::castThrough(const Eigen::Matrix2Xd& places,
                                            const Cancellation& cancellation) const {
  Eigen::Matrix3Xd points(3, places.cols());
  points.row(0).setConstant(std::numeric_limits<double>::quiet_NaN());
  points.bottomRows<2>() = places;
  std::vector<Index> missed = scene_->withinReach(places);
  for (const auto& [y, z] : kOffsets) {
    for (std::size_t begin = 0; begin < missed.size(); begin += kPacket) {
      if (begin % kRaysPerCheck == 0) {
        cancellation.check();
      }
      const auto rest = std::span<const Index>(missed).subspan(begin);
      scene_->castPacket(rest.first(std::min<std::size_t>(kPacket, rest.size())),
                         kReach * Vector2d(y, z), points);
    }
    std::erase_if(missed, [&](Index ray) { return !std::isnan(points(0, ray)); });
  }
  return points;
}

}  // namespace morphgrid
