#include "export/vtu_file.h"

#include <fmt/format.h>

#include <bit>
#include <cassert>
#include <cstdint>

#include "core/atomic_file.h"

namespace morphgrid {
namespace {

static_assert(std::endian::native == std::endian::little);  // As the header says.

constexpr std::uint8_t kLine = 3;  // VTK's number of that kind of cell.

template <typename Value>
constexpr const char* typeName();
template <>
constexpr const char* typeName<double>() {
  return "Float64";
}
template <>
constexpr const char* typeName<int>() {
  return "Int32";
}
template <>
constexpr const char* typeName<std::uint8_t>() {
  return "UInt8";
}

template <typename Value>
std::string attributesOf(const char* name, int components) {
  return fmt::format(R"(type="{}" Name="{}" NumberOfComponents="{}")", typeName<Value>(), name,
                     components);
}

template <typename Value>
void writeValues(std::ostream& stream, const Value* values, std::size_t bytes) {
  stream.write(reinterpret_cast<const char*>(values), static_cast<std::streamsize>(bytes));
}

/// visit(strut) gives `perStrut` values.
template <typename Value, int perStrut, typename Visit>
void writePerStrut(std::ostream& stream, const GridShape& shape, const Visit& visit) {
  std::vector<Value> values;
  values.reserve(perStrut * static_cast<std::size_t>(shape.strutCount()));
  forEachStrut(shape, [&](const Strut& strut) { visit(values, strut); });
  writeValues(stream, values.data(), values.size() * sizeof(Value));
}

std::string section(const char* name, const std::string& attributes, const std::string& arrays) {
  return fmt::format("<{}{}>\n{}</{}>\n", name, attributes, arrays, name);
}

}  // namespace

VtuFile::VtuFile(const GridShape& shape, const Eigen::Matrix3Xd& positions) : shape_(shape) {
  assert(positions.cols() == shape.vertexCount());
  points_ = {vectorArray("Points", positions)};
  const auto count = static_cast<std::size_t>(shape.strutCount());
  cells_.push_back({attributesOf<int>("connectivity", 1), 2 * count * sizeof(int),
                    [shape](std::ostream& stream) {
                      writePerStrut<int, 2>(stream, shape, [](auto& values, const Strut& strut) {
                        values.push_back(strut.from);
                        values.push_back(strut.to);
                      });
                    }});
  cells_.push_back(
      {attributesOf<int>("offsets", 1), count * sizeof(int), [shape](std::ostream& stream) {
         writePerStrut<int, 1>(stream, shape, [](auto& values, const Strut&) {
           values.push_back(2 * static_cast<int>(values.size() + 1));
         });
       }});
  cells_.push_back({attributesOf<std::uint8_t>("types", 1), count, [shape](std::ostream& stream) {
                      writePerStrut<std::uint8_t, 1>(stream, shape, [](auto& values, const Strut&) {
                        values.push_back(kLine);
                      });
                    }});
}

VtuFile::Array VtuFile::vectorArray(const char* name, const Eigen::Matrix3Xd& values) const {
  const std::size_t bytes = static_cast<std::size_t>(values.size()) * sizeof(double);
  return {attributesOf<double>(name, 3), bytes,
          [&values, bytes](std::ostream& stream) { writeValues(stream, values.data(), bytes); }};
}

template <typename Value>
VtuFile::Array VtuFile::strutArray(const char* name, ValueOf<Value> valueOf) const {
  return {attributesOf<Value>(name, 1),
          static_cast<std::size_t>(shape_.strutCount()) * sizeof(Value),
          [shape = shape_, valueOf = std::move(valueOf)](std::ostream& stream) {
            writePerStrut<Value, 1>(stream, shape, [&](auto& values, const Strut& strut) {
              values.push_back(valueOf(strut, values.size()));
            });
          }};
}

void VtuFile::addPointArray(const char* name, const Eigen::Matrix3Xd& values) {
  assert(values.cols() == shape_.vertexCount());
  pointArrays_.push_back(vectorArray(name, values));
}

void VtuFile::addDoubles(const char* name, ValueOf<double> valueOf) {
  if (cellArrays_.empty()) activeCellArray_ = fmt::format(R"( Scalars="{}")", name);
  cellArrays_.push_back(strutArray<double>(name, std::move(valueOf)));
}

void VtuFile::addInts(const char* name, ValueOf<int> valueOf) {
  cellArrays_.push_back(strutArray<int>(name, std::move(valueOf)));
}

std::string VtuFile::header() const {
  std::size_t offset = 0;
  const auto arraysOf = [&](const std::vector<Array>& arrays) {
    std::string text;
    for (const Array& array : arrays) {
      text += fmt::format("<DataArray {} format=\"appended\" offset=\"{}\"/>\n", array.attributes,
                          offset);
      offset += sizeof(std::uint64_t) + array.bytes;
    }
    return text;
  };
  const std::string points = section("Points", "", arraysOf(points_));
  const std::string cells = section("Cells", "", arraysOf(cells_));
  const std::string pointArrays = section("PointData", "", arraysOf(pointArrays_));
  const std::string cellArrays = section("CellData", activeCellArray_, arraysOf(cellArrays_));
  return fmt::format(
      "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\"{}\" "
      "NumberOfCells=\"{}\">\n{}{}{}{}</Piece>\n</UnstructuredGrid>\n<AppendedData "
      "encoding=\"raw\">\n_",
      shape_.vertexCount(), shape_.strutCount(), points, cells, pointArrays, cellArrays);
}

void VtuFile::write(const std::filesystem::path& path) const {
  writeFileAtomically(path, [&](std::ostream& stream) {
    stream << header();
    for (const auto* arrays : {&points_, &cells_, &pointArrays_, &cellArrays_}) {
      for (const Array& array : *arrays) {
        const std::uint64_t bytes = array.bytes;
        writeValues(stream, &bytes, sizeof(bytes));
        array.write(stream);
      }
    }
    stream << "\n</AppendedData>\n</VTKFile>\n";
  });
}

}  // namespace morphgrid
