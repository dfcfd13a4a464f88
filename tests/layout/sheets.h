#pragma once
#include <Eigen/Geometry>
#include <functional>

#include "layout/sheet_problem.h"

namespace morphgrid {

/// A net of a surface, of parameters in [0, 1]^2, whose layers all rest at the surface's chords.
inline SheetProblem netOn(const std::function<Eigen::Vector3d(double, double)>& surface,
                          int verticesU, int verticesV, const ShrinkRange& shrink = {}) {
  constexpr double kStep = 1e-6;
  const GridShape layer{verticesU, verticesV, 1};
  SheetProblem problem{.layer = layer,
                       .points = Eigen::Matrix3Xd(3, layer.layerVertexCount()),
                       .normals = Eigen::Matrix3Xd(3, layer.layerVertexCount()),
                       .rest = {LateralField<double>(layer.cellsU(), layer.cellsV())},
                       .shrink = {shrink}};
  forEachVertex(layer, [&](const GridPlace& place) {
    const double u = place.i / double(layer.cellsU());
    const double v = place.j / double(layer.cellsV());
    const int n = layer.index(place);
    problem.points.col(n) = surface(u, v);
    problem.normals.col(n) = (surface(u + kStep, v) - surface(u - kStep, v))
                                 .cross(surface(u, v + kStep) - surface(u, v - kStep))
                                 .normalized();
  });
  forEachLateralStrut(layer, [&](const Strut& strut) {
    problem.rest[0].at(strut) =
        (problem.points.col(strut.to) - problem.points.col(strut.from)).norm();
  });
  return problem;
}

inline Eigen::Vector3d onSkewedPlane(double u, double v) { return {2 * u + 0.5 * v, v, 0}; }

/// A third of a cylinder of radius 1, its axis along y.
inline Eigen::Vector3d onCylinder(double u, double v) {
  return {std::sin(2 * u - 1), 1.5 * v, std::cos(2 * u - 1)};
}

/// By stereographic projection: its isolines cross at right angles.
inline Eigen::Vector3d onSphere(double u, double v) {
  const double x = u - 0.5;
  const double y = v - 0.5;
  const double square = x * x + y * y;
  return Eigen::Vector3d(2 * x, 2 * y, 1 - square) / (1 + square);
}

}  // namespace morphgrid
