#include "torso_body.h"

#include <algorithm>
#include <cmath>
#include <variant>

namespace morphgrid {
namespace {

using Eigen::Vector3d;

struct Ellipsoid {
  Vector3d centre;
  Vector3d radii;
};

struct Capsule {
  Vector3d from, to;
  double radius;
};

enum class Side { middle, both };
enum class Effect { add, carve };

struct Part {
  const char* name;
  std::variant<Ellipsoid, Capsule> shape;
  double blend;  ///< How far the skin rounds the crease where this part meets those before it, cm.
  Side side = Side::middle;  ///< Where it is `both`, the shape is that at x > 0.
  Effect effect = Effect::add;
};

const Part kParts[] = {
    {"rib cage", Ellipsoid{{0, 46, -1}, {15, 18.5, 9.6}}, 0},
    {"abdomen", Ellipsoid{{0, 26, -0.5}, {12.8, 20, 8}}, 2.5},
    {"hips", Ellipsoid{{0, 8, -1}, {16.4, 12, 9}}, 5},
    {"back", Ellipsoid{{11, 46, -3}, {6, 13, 5.5}}, 2.5, Side::both},
    {"shoulder", Ellipsoid{{17.5, 57.5, -1.5}, {5.5, 6.5, 6}}, 3, Side::both},
    {"arm", Capsule{{19.5, 56, -1.5}, {22.5, 49, -1.5}, 4.6}, 2, Side::both},
    {"neck", Capsule{{0, 58, -2.5}, {0, 71, -0.5}, 5.2}, 2},
    {"trapezius", Capsule{{3, 67, -4}, {15, 62, -3}, 3}, 3, Side::both},
    {"pectoral", Ellipsoid{{7, 48.5, 6.2}, {8, 6.2, 4}}, 1.4, Side::both},
    {"clavicle", Capsule{{2.4, 58.2, 6.2}, {13, 60.4, 3.6}, 1.5}, 1.2, Side::both},
    {"costal arch", Capsule{{2.2, 38.5, 6.9}, {9, 31, 4.6}, 1.7}, 1.4, Side::both},
    {"rectus abdominis", Capsule{{3.4, 12, 6.1}, {3.4, 37, 6.1}, 2.6}, 1, Side::both},
    {"buttock", Ellipsoid{{7.2, 4.5, -5}, {7, 8, 6}}, 2, Side::both},
    {"thigh", Capsule{{8.6, 3, -0.5}, {9.8, -5, -0.5}, 7.4}, 3, Side::both},
    {"navel", Ellipsoid{{0, 24.5, 10.9}, {1.7, 2.1, 2.1}}, 1.9, Side::middle, Effect::carve},
};

/// Exact on the skin and to first order around it.
double distance(const Ellipsoid& ellipsoid, const Vector3d& point) {
  const Vector3d p = point - ellipsoid.centre;
  const double level = p.cwiseQuotient(ellipsoid.radii).norm();
  const double slope = p.cwiseQuotient(ellipsoid.radii.cwiseAbs2()).norm();
  return slope > 0 ? level * (level - 1) / slope : -ellipsoid.radii.minCoeff();
}

double distance(const Capsule& capsule, const Vector3d& point) {
  const Vector3d axis = capsule.to - capsule.from;
  const Vector3d p = point - capsule.from;
  const double t = std::clamp(p.dot(axis) / axis.squaredNorm(), 0.0, 1.0);
  return (p - t * axis).norm() - capsule.radius;
}

double distance(const Part& part, const Vector3d& point) {
  return std::visit([&](const auto& shape) { return distance(shape, point); }, part.shape);
}

/// A hyperbola in place of the minimum's corner, blend / 2 below it at most.
double smoothMinimum(double a, double b, double blend) {
  return (a + b - std::sqrt((a - b) * (a - b) + blend * blend)) / 2;
}

double combine(double body, const Part& part, double distance) {
  return part.effect == Effect::add ? smoothMinimum(body, distance, part.blend)
                                    : -smoothMinimum(-body, distance, part.blend);
}

}  // namespace

double torsoField(const Vector3d& point) {
  const Vector3d mirrored(-point.x(), point.y(), point.z());
  double body = 1e3;  // Far from the first part.
  for (const Part& part : kParts) {
    body = combine(body, part, distance(part, point));
    if (part.side == Side::both) body = combine(body, part, distance(part, mirrored));
  }
  return body;
}

}  // namespace morphgrid
