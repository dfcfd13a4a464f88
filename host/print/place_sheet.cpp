#include "print/place_sheet.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <numbers>
#include <vector>

namespace morphgrid {
namespace {

Eigen::Matrix2Xd turned(const Eigen::Matrix2Xd& points, int degrees) {
  const Eigen::Matrix2d rotation =
      Eigen::Rotation2Dd(degrees * std::numbers::pi / 180).toRotationMatrix();
  return rotation * points;
}

Eigen::Vector2d extentOf(const Eigen::Matrix2Xd& points) {
  return points.rowwise().maxCoeff() - points.rowwise().minCoeff();
}

double crossProduct(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

}  // namespace

SheetPlacing placeSheet(const Eigen::Matrix2Xd& points, double hubs, const Printer& printer) {
  const Eigen::Vector2d room =
      Eigen::Vector2d(printer.bedX, printer.bedY).array() - 2 * printer.margin - hubs;
  SheetPlacing best{.room = -std::numeric_limits<double>::infinity()};
  for (int degrees = 0; degrees < 180; ++degrees) {
    const Eigen::Vector2d extent = extentOf(turned(points, degrees));
    const double factor = room.cwiseQuotient(extent).minCoeff();
    if (factor > best.room + 1e-9) {
      best = {degrees, factor, extent.array() + hubs};
    }
  }
  return best;
}

std::string whyNoRoom(double hub, const Printer& printer) {
  return fmt::format(
      "a hub of {:.2f} mm does not fit what a margin of {:g} mm leaves of {:g} x {:g} mm", hub,
      printer.margin, printer.bedX, printer.bedY);
}

Eigen::Matrix2Xd onBed(const Eigen::Matrix2Xd& points, int degrees, const Printer& printer) {
  const Eigen::Matrix2Xd lying = turned(points, degrees);
  const Eigen::Vector2d middle = (lying.rowwise().maxCoeff() + lying.rowwise().minCoeff()) / 2;
  return lying.colwise() + (Eigen::Vector2d(printer.bedX, printer.bedY) / 2 - middle);
}

Eigen::Matrix2Xd convexOutline(const Eigen::Matrix2Xd& points) {
  std::vector<Eigen::Vector2d> sorted;
  for (const auto& point : points.colwise()) sorted.emplace_back(point);
  std::sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) {
    return std::pair(a.x(), a.y()) < std::pair(b.x(), b.y());
  });
  std::vector<Eigen::Vector2d> outline;
  const auto walk = [&](auto begin, auto end) {  // Andrew's monotone chain, one side of it.
    const std::size_t start = outline.size();
    for (auto point = begin; point != end; ++point) {
      while (outline.size() >= start + 2 &&
             crossProduct(outline.back() - outline[outline.size() - 2], *point - outline.back()) <=
                 0) {
        outline.pop_back();
      }
      outline.push_back(*point);
    }
    outline.pop_back();  // The other side begins with it.
  };
  walk(sorted.begin(), sorted.end());
  walk(sorted.rbegin(), sorted.rend());
  Eigen::Matrix2Xd result(2, outline.size());
  for (std::size_t n = 0; n < outline.size(); ++n) result.col(n) = outline[n];
  return result;
}

}  // namespace morphgrid
