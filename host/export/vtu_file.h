#pragma once
#include <Eigen/Core>
#include <filesystem>
#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include "grid/grid_topology.h"

namespace morphgrid {

/// VTK's XML file of an unstructured grid whose cells are a grid's struts as lines, in the order of
/// forEachStrut(). Arrays are appended to the XML as they are, neither packed nor encoded, and made
/// one after the other while the file is written: what they are made of must live until then.
class VtuFile {
 public:
  template <typename Value>
  using ValueOf = std::function<Value(const Strut&, std::size_t n)>;

  /// positions: 3 x shape.vertexCount().
  VtuFile(const GridShape& shape, const Eigen::Matrix3Xd& positions);

  /// values: 3 x vertexCount.
  void addPointArray(const char* name, const Eigen::Matrix3Xd& values);
  /// valueOf(strut, n): of the n-th strut, from 0. The first array of doubles is the active one.
  void addDoubles(const char* name, ValueOf<double> valueOf);
  void addInts(const char* name, ValueOf<int> valueOf);

  /// Throws OutputError when the disk refuses.
  void write(const std::filesystem::path& path) const;

 private:
  /// Values of one array, in the order of the file.
  struct Array {
    std::string attributes;
    std::size_t bytes;
    std::function<void(std::ostream&)> write;
  };

  template <typename Value>
  Array strutArray(const char* name, ValueOf<Value> valueOf) const;
  Array vectorArray(const char* name, const Eigen::Matrix3Xd& values) const;
  std::string header() const;

  GridShape shape_;
  std::vector<Array> points_;  ///< Only one.
  std::vector<Array> cells_;   ///< Their vertices, where each ends, their kind.
  std::vector<Array> pointArrays_;
  std::vector<Array> cellArrays_;
  std::string activeCellArray_;
};

}  // namespace morphgrid
