#include "design/grid_design.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.h"

namespace morphgrid {
namespace {

std::string describe(const GridShape& shape, const Strut& strut) {
  const GridPlace place = shape.place(strut.from);
  return fmt::format("the {} strut at node ({}, {})",
                     strut.direction == Strut::Direction::u ? "u" : "v", place.i, place.j);
}

/// Every strut needs a length, or it cannot be printed.
void requireLengths(const LateralField<double>& lengths, double longest) {
  forEachLateralStrut(lengths.shape(), [&](const Strut& strut) {
    if (!(lengths.at(strut) > 1e-9 * longest)) {
      throw InputError(
          fmt::format("{} has no length ({:.3g}): the surface is "
                      "collapsed there; move the control points that coincide apart",
                      describe(lengths.shape(), strut), lengths.at(strut)));
    }
  });
}

double largest(const LateralField<double>& field) {
  return std::max(*std::max_element(field.allU().begin(), field.allU().end()),
                  *std::max_element(field.allV().begin(), field.allV().end()));
}

/// Eq. 24, with the sine clamped; counts the clamped struts.
double bendAngle(double length, double curvature, int& clamped) {
  const double sine = length * curvature / 2;
  if (std::abs(sine) > 1) {
    ++clamped;
  }
  return 2 * std::asin(std::clamp(sine, -1.0, 1.0));
}

/// Eq. 25 in every layer.
void setRestOfConvexSides(GridDesign& design) {
  for (int k = 0; k < design.layers; ++k) {
    LateralField<double> layer(design.nodesU, design.nodesV);
    forEachLateralStrut(layer.shape(), [&](const Strut& strut) {
      layer.at(strut) = restLength(design.lengths.at(strut), design.bendAngles.at(strut),
                                   design.layerSpacing, k, design.layers);
    });
    design.rest.push_back(std::move(layer));
  }
}

Eigen::Vector3d along(const Eigen::Matrix3Xd& values, const Strut& strut) {
  return values.col(strut.to) - values.col(strut.from);
}

/// How much more lengths must differ between layers where bars resist being bent by themselves.
double bendingGain(const LayerStack& stack) {
  double squares = 0;
  for (int k = 0; k < stack.layers; ++k) {
    squares += stack.height(k) * stack.height(k);
  }
  return stack.layers > 1 ? 1 + stack.layers * stack.barHeight * stack.barHeight / (12 * squares)
                          : 1;
}

/// Throws InputError when a strut would run backwards, or have no length, in an outermost layer:
/// that is beyond the surface's centre of curvature.
void requireStruts(const SurfaceMeasurement& measurement, const Eigen::Matrix3Xd& normals,
                   const LayerStack& stack) {
  const double outermost = bendingGain(stack) * stack.height(stack.layers - 1);
  double smallest = std::numeric_limits<double>::infinity();
  Strut tightest{};
  forEachLateralStrut(measurement.chords.shape(), [&](const Strut& strut) {
    const Eigen::Vector3d chord = along(measurement.points, strut);
    const double radius = chord.squaredNorm() / std::abs(chord.dot(along(normals, strut)));
    if (radius < smallest) {
      smallest = radius;
      tightest = strut;
    }
  });
  if (outermost < smallest) return;
  const Eigen::Vector3d point = measurement.points.col(tightest.from);
  throw InputError(fmt::format(
      "{}, at ({:.4g}, {:.4g}, {:.4g}), has no length left in the "
      "outermost layer: the surface's radius there is {:.4g}; grid.layer_spacing must be below "
      "{:.4g}, got {:.4g}",
      describe(measurement.chords.shape(), tightest), point.x(), point.y(), point.z(), smallest,
      stack.spacing * smallest / outermost, stack.spacing));
}

/// Along u, across it, and the normal, at each vertex: by central differences, one-sided at the
/// edges.
std::vector<Eigen::Matrix3d> localAxes(const GridShape& layer, const Eigen::Matrix3Xd& points) {
  std::vector<Eigen::Matrix3d> axes(points.cols());
  forEachVertex(layer, [&](const GridPlace& place) {
    const auto point = [&](int i, int j) {
      return points.col(
          layer.index(std::clamp(i, 0, layer.cellsU()), std::clamp(j, 0, layer.cellsV()), 0));
    };
    const Eigen::Vector3d u = point(place.i + 1, place.j) - point(place.i - 1, place.j);
    const Eigen::Vector3d v = point(place.i, place.j + 1) - point(place.i, place.j - 1);
    Eigen::Matrix3d& here = axes[layer.index(place)];
    here.col(0) = u.normalized();
    here.col(2) = u.cross(v).normalized();
    here.col(1) = here.col(2).cross(here.col(0));
  });
  return axes;
}

}  // namespace

GridDesign designGrid(const SurfaceMeasurement& measurement, const GridSize& size, int layers) {
  const int nodesU = measurement.nodesU;
  const int nodesV = measurement.nodesV;
  GridDesign design{nodesU,
                    nodesV,
                    layers,
                    size.layerSpacing,
                    largest(measurement.chords),
                    measurement.chords,
                    LateralField<double>(nodesU, nodesV),
                    {},
                    {}};
  requireLengths(design.lengths, design.spacing);
  int clamped = 0;
  forEachLateralStrut(design.lengths.shape(), [&](const Strut& strut) {
    design.bendAngles.at(strut) =
        bendAngle(measurement.chords.at(strut), measurement.curvatures.at(strut), clamped);
  });
  setRestOfConvexSides(design);
  if (clamped > 0) {
    design.notices.push_back(fmt::format(
        "{} struts are longer than the diameter of their circle of curvature; their bend angle is "
        "clamped to pi (Eq. 24)",
        clamped));
  }
  return design;
}

std::vector<LateralField<double>> lengthsOnOffsets(const GridShape& layer,
                                                   const Eigen::Matrix3Xd& points,
                                                   const Eigen::Matrix3Xd& normals,
                                                   const LayerStack& stack) {
  const double gain = bendingGain(stack);
  std::vector<LateralField<double>> rest;
  for (int k = 0; k < stack.layers; ++k) {
    rest.emplace_back(layer.cellsU(), layer.cellsV());
    forEachLateralStrut(layer, [&](const Strut& strut) {
      const Eigen::Vector3d chord = along(points, strut);
      const double middle = chord.norm();
      const double offset = (chord + stack.height(k) * along(normals, strut)).norm();
      rest.back().at(strut) = middle + gain * (offset - middle);
    });
  }
  return rest;
}

GridDesign designOnOffsets(const SurfaceMeasurement& measurement, const Eigen::Matrix3Xd& normals,
                           const LayerStack& stack) {
  const int nodesU = measurement.nodesU;
  const int nodesV = measurement.nodesV;
  const LateralField<double> zero(nodesU, nodesV);
  requireLengths(measurement.chords, largest(measurement.chords));
  requireStruts(measurement, normals, stack);
  GridDesign design{
      nodesU,
      nodesV,
      stack.layers,
      stack.spacing,
      0,
      zero,
      zero,
      lengthsOnOffsets(measurement.chords.shape(), measurement.points, normals, stack),
      {}};
  const double between = stack.height(stack.layers - 1) - stack.height(0);
  forEachLateralStrut(design.lengths.shape(), [&](const Strut& strut) {
    const double bottom = design.rest.front().at(strut);
    const double top = design.rest.back().at(strut);
    design.lengths.at(strut) = std::max(bottom, top);
    design.bendAngles.at(strut) =
        stack.layers > 1 ? 2 * std::asin(std::clamp((bottom - top) / (2 * between), -1.0, 1.0)) : 0;
  });
  design.spacing = largest(design.lengths);
  return design;
}

Eigen::Matrix3Xd carryNormals(const GridShape& layer, const Eigen::Matrix3Xd& before,
                              const Eigen::Matrix3Xd& normals, const Eigen::Matrix3Xd& after) {
  const std::vector<Eigen::Matrix3d> from = localAxes(layer, before);
  const std::vector<Eigen::Matrix3d> to = localAxes(layer, after);
  Eigen::Matrix3Xd carried(3, normals.cols());
  for (Eigen::Index n = 0; n < normals.cols(); ++n) {
    carried.col(n) = to[n] * (from[n].transpose() * normals.col(n));
  }
  return carried;
}

GridDesign designFromBendAngles(const BendAngleRequest& request, int layers, double layerSpacing) {
  const int nodesU = request.nodesU;
  const int nodesV = request.nodesV;
  GridDesign design{nodesU,
                    nodesV,
                    layers,
                    layerSpacing,
                    request.spacing,
                    LateralField<double>(nodesU, nodesV, request.spacing),
                    LateralField<double>(nodesU, nodesV),
                    {},
                    {}};
  const auto ramp = [](double first, double last, int strut, int count) {
    return count > 1 ? first + (last - first) * strut / (count - 1) : 0.5 * (first + last);
  };
  const GridShape layer = design.lengths.shape();
  forEachLateralStrut(layer, [&](const Strut& strut) {
    const GridPlace place = layer.place(strut.from);
    design.bendAngles.at(strut) =
        strut.direction == Strut::Direction::u
            ? ramp(request.firstThetaU, request.lastThetaU, place.i, nodesU)
            : ramp(request.firstThetaV, request.lastThetaV, place.j, nodesV);
  });
  setRestOfConvexSides(design);
  const double shrink = largestBendShrink(design);
  if (shrink >= 1) {
    throw InputError(
        fmt::format("bend angle, layer spacing {:g} and {} layers leave a strut of length {:g} "
                    "nothing (shrinkage "
                    "{:.4g} %, must be below 100 %); lower one of them",
                    layerSpacing, layers, request.spacing, 100 * shrink));
  }
  return design;
}

double restLength(double length, double bendAngle, double layerSpacing, int layer, int layers) {
  const int fromConvexSide = bendAngle > 0 ? layer : layers - 1 - layer;
  return length - 2 * fromConvexSide * layerSpacing * std::sin(std::abs(bendAngle) / 2);
}

double largestBendShrink(const GridDesign& design) {
  double shrink = 0;
  for (const LateralField<double>& layer : design.rest) {
    forEachLateralStrut(layer.shape(), [&](const Strut& strut) {
      shrink = std::max(shrink, 1 - layer.at(strut) / design.lengths.at(strut));
    });
  }
  return shrink;
}

}  // namespace morphgrid
