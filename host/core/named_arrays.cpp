#include "core/named_arrays.h"

#include <cmath>

namespace morphgrid {

void ArrayList::addMade(const std::string& name, ArrayShape shape, std::vector<double> values) {
  add(name, std::move(shape), std::span<const double>(made_.emplace_back(std::move(values))));
}

double ArrayReader::number(const std::string& name) const {
  double value = 0;
  file_.copy(name, std::span(&value, 1));
  require(std::isfinite(value));
  return value;
}

std::vector<double> ArrayReader::numbers(const std::string& name, const ArrayShape& shape,
                                         double low) const {
  std::vector<double> values = bare(name, shape);
  for (const double value : values) {
    require(std::isfinite(value) && value > low);
  }
  return values;
}

std::vector<double> ArrayReader::bare(const std::string& name, const ArrayShape& shape) const {
  require(file_.shapeOf(name) == shape);
  std::vector<double> values(elementCount(shape));
  file_.copy(name, values);
  return values;
}

std::size_t ArrayReader::rowCount(const std::string& name, std::size_t rowLength) const {
  const ArrayShape& shape = file_.shapeOf(name);
  require(shape.size() == 2 && shape[1] == rowLength);
  return shape[0];
}

Eigen::Matrix3Xd ArrayReader::points(const std::string& name, const ArrayShape& shape) const {
  require(file_.shapeOf(name) == shape);
  Eigen::Matrix3Xd points(3, static_cast<Eigen::Index>(elementCount(shape) / 3));
  file_.copy(name, std::span(points.data(), static_cast<std::size_t>(points.size())));
  require(points.allFinite());
  return points;
}

long ArrayReader::integer(double value, double low, double high) const {
  require(value >= low && value <= high && value == std::floor(value));
  return static_cast<long>(value);
}

}  // namespace morphgrid
