// From triangle meshes of known surfaces, through rays, to lengths and curvatures.
#include <gmock/gmock.h>

#include <cmath>
#include <functional>
#include <ostream>

#include "measure/lattice_measurement.h"
#include "surface/mesh_ray_caster.h"

namespace morphgrid {
namespace {

using Eigen::Vector3d;
using Parametrisation = std::function<Vector3d(double, double)>;

constexpr SamplingBox kBox{-0.5, -0.5, 1, 1};
constexpr double kNoLimit = 1e300;

struct KnownSurface {
  const char* name;
  Parametrisation point;  ///< Over [-1, 1]^2, covers the box.
  double longestIsolineU;
  std::function<double(double, double)> curvatureU;  ///< A function of y and z.
  std::function<double(double, double)> curvatureV;
};

std::ostream& operator<<(std::ostream& stream, const KnownSurface& surface) {
  return stream << surface.name;
}

/// Length of the arc over a chord.
double arc(double radius, double chord) { return 2 * radius * std::asin(chord / 2 / radius); }

std::vector<KnownSurface> knownSurfaces() {
  return {
      {"sphere",
       [](double s, double t) {
         return Vector3d(-std::cos(s) * std::cos(t), std::sin(s) * std::cos(t), std::sin(t));
       },
       arc(std::sqrt(0.75), 1),  // Along the box's edges.
       [](double, double z) { return 1 / std::sqrt(1 - z * z); },
       [](double y, double) { return 1 / std::sqrt(1 - y * y); }},
      {"cylinder", [](double s, double t) { return Vector3d(-std::cos(s), std::sin(s), t); },
       arc(1, 1), [](double, double) { return 1; }, [](double, double) { return 0; }},
      {"saddle", [](double s, double t) { return Vector3d((s * s - t * t) / 2, s, t); },
       0.5 * std::sqrt(1.25) + std::asinh(0.5),
       [](double y, double) { return 1 / std::pow(1 + y * y, 1.5); },
       [](double, double z) { return -1 / std::pow(1 + z * z, 1.5); }},
  };
}

/// cells x cells quads, each of two triangles; off the middle, so that no vertices lie on rays.
TriangleMesh triangulate(const Parametrisation& point, int cells) {
  const int count = cells + 1;
  TriangleMesh mesh{Eigen::Matrix3Xd(3, count * count), Eigen::Matrix3Xi(3, 2 * cells * cells)};
  for (int j = 0; j < count; ++j) {
    for (int i = 0; i < count; ++i) {
      mesh.vertices.col(j * count + i) = point(-0.97 + 1.93 * i / cells, -0.96 + 1.91 * j / cells);
    }
  }
  for (int j = 0; j < cells; ++j) {
    for (int i = 0; i < cells; ++i) {
      const int corner = j * count + i;
      const int triangle = 2 * (j * cells + i);
      mesh.triangles.col(triangle) << corner, corner + 1, corner + count + 1;
      mesh.triangles.col(triangle + 1) << corner, corner + count + 1, corner + count;
    }
  }
  return mesh;
}

struct Errors {
  double length;     ///< Error of the length of the longest isoline along u.
  double curvature;  ///< RMS over the struts that are not at the box's edge.
};

/// The curvature of a strut is compared with that at the middle of its ends.
Errors errorsOf(const KnownSurface& known, int rays, int cells) {
  const MeshRayCaster caster(triangulate(known.point, cells));
  const PointLattice hits = caster.cast(kBox, rays, rays).lattice();
  const SurfaceMeasurement m = measureLattice(hits, kNoLimit, 0);
  double sum = 0;
  int count = 0;
  const auto add = [&](double curvature, int from, int to, const auto& exact) {
    const Vector3d middle = (hits.points.col(from) + hits.points.col(to)) / 2;
    sum += std::pow(curvature - exact(middle.y(), middle.z()), 2);
    ++count;
  };
  for (int line = 0; line < rays; ++line) {
    for (int k = 1; k < rays - 2; ++k) {
      add(m.curvatures.u(k, line), hits.index(k, line), hits.index(k + 1, line), known.curvatureU);
      add(m.curvatures.v(line, k), hits.index(line, k), hits.index(line, k + 1), known.curvatureV);
    }
  }
  const double length = surveyLattice(hits, 0).survey.longestIsolineU;
  return {std::abs(length - known.longestIsolineU), std::sqrt(sum / count)};
}

class CurvedMeshes : public testing::TestWithParam<KnownSurface> {};

TEST_P(CurvedMeshes, LengthAndCurvatureConvergeAtSecondOrder) {
  // Facets of size e leave rays e^2 / 8R beside the surface; second differences over the rays'
  // distance h make (e / h)^2 / R of that. So e = h^2 keeps the order of the splines.
  const Errors coarse = errorsOf(GetParam(), 9, 64);
  const Errors fine = errorsOf(GetParam(), 17, 256);
  EXPECT_NEAR(std::log2(coarse.length / fine.length), 2, 0.3);
  EXPECT_NEAR(std::log2(coarse.curvature / fine.curvature), 2, 0.4);
  EXPECT_LT(fine.length, 1e-3);
  EXPECT_LT(fine.curvature, 1e-2);
}

TEST_P(CurvedMeshes, FacetsFinerThanTheRaysDoNotShow) {
  const Errors coarse = errorsOf(GetParam(), 21, 20);
  const Errors fine = errorsOf(GetParam(), 21, 200);
  EXPECT_GT(coarse.curvature, 10 * fine.curvature);
}

INSTANTIATE_TEST_SUITE_P(, CurvedMeshes, testing::ValuesIn(knownSurfaces()),
                         [](const auto& surface) { return surface.param.name; });

}  // namespace
}  // namespace morphgrid
