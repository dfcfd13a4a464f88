#pragma once
#include <Eigen/Core>
#include <deque>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "core/array_file.h"

namespace morphgrid {

/// The arrays of a file that is to be written, and the values of those that had to be made for it.
class ArrayList {
 public:
  /// Keeps a reference to the values, as many as the shape holds.
  template <typename Value>
  void add(const std::string& name, ArrayShape shape, std::span<const Value> values) {
    arrays_.push_back({name, viewOf(std::move(shape), values)});
  }
  /// The columns one after the other. Keeps a reference.
  template <typename Value, int rows, int columns>
  void add(const std::string& name, ArrayShape shape,
           const Eigen::Matrix<Value, rows, columns>& matrix) {
    add(name, std::move(shape),
        std::span<const Value>(matrix.data(), static_cast<std::size_t>(matrix.size())));
  }
  void addMade(const std::string& name, ArrayShape shape, std::vector<double> values);
  void add(const std::string& name, double value) { addMade(name, {}, {value}); }

  const std::vector<NamedArray>& all() const { return arrays_; }

 private:
  std::vector<NamedArray> arrays_;
  std::deque<std::vector<double>> made_;
};

/// Takes a file's arrays. All throw InputError, the file is damaged, where there is no such array,
/// or it is not as the caller says that it must be.
class ArrayReader {
 public:
  /// Keeps a reference.
  explicit ArrayReader(const ArrayFile& file) : file_(file) {}

  void require(bool holds) const {
    if (!holds) file_.refuse();
  }
  bool has(const std::string& name) const { return file_.has(name); }
  const ArrayFile& file() const { return file_; }

  /// A single number, finite.
  double number(const std::string& name) const;
  /// The same, or `otherwise` where there is no such array.
  double number(const std::string& name, double otherwise) const {
    return has(name) ? number(name) : otherwise;
  }
  /// All finite and above `low`.
  std::vector<double> numbers(const std::string& name, const ArrayShape& shape,
                              double low = -std::numeric_limits<double>::infinity()) const;
  /// Numbers of any kind, infinite ones and NaN too.
  std::vector<double> bare(const std::string& name, const ArrayShape& shape) const;
  /// How many rows of so many numbers each an array has.
  std::size_t rowCount(const std::string& name, std::size_t rowLength) const;
  /// A column for each point, all finite; the shape's last extent is 3.
  Eigen::Matrix3Xd points(const std::string& name, const ArrayShape& shape) const;

  /// A number of the file that must be an integer within [low, high].
  long integer(double value, double low, double high) const;

 private:
  const ArrayFile& file_;
};

}  // namespace morphgrid
