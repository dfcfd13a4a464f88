#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <limits>

#include "tests/surface/mesh_files.h"

namespace morphgrid {
namespace {

std::string header(const std::string& format, const std::string& vertexProperties,
                   const std::string& list = "uchar int vertex_indices") {
  return "ply\nformat " + format + " 1.0\ncomment a comment\nelement vertex 3\n" +
         vertexProperties + "element face 1\nproperty list " + list + "\nend_header\n";
}

const std::string kFloats = "property float x\nproperty float y\nproperty float z\n";

std::string ascii(const std::string& rows) { return header("ascii", kFloats) + rows; }

std::string replaced(std::string text, const std::string& old, const std::string& replacement) {
  return text.replace(text.find(old), old.size(), replacement);
}

const std::string kRows = "0 0 0\n1 0 0\n0 1 0.5\n3 0 1 2\n";

/// A value's bytes in the other order.
template <typename Value>
std::string swapped(Value value) {
  std::string bytes = bytesOf(value);
  std::ranges::reverse(bytes);
  return bytes;
}

void expectTheTriangle(const TriangleMesh& mesh) {
  EXPECT_EQ(mesh.triangles, Eigen::Vector3i(0, 1, 2));
  ASSERT_EQ(mesh.vertices.cols(), 3);
  EXPECT_EQ(mesh.vertices.col(1), Eigen::Vector3d(1, 0, 0));
  EXPECT_EQ(mesh.vertices.col(2), Eigen::Vector3d(0, 1, 0.5));
}

TEST(ReadPly, ReadsAscii) {
  expectTheTriangle(meshOf("a.ply", ascii(kRows)));
  expectTheTriangle(meshOf("a.ply", ascii("0 0 0 1 0 0\n\n0 1\n0.5 3 0 1 2")));
  expectTheTriangle(meshOf("a.ply", withLineEnds(ascii(kRows), "\r\n")));
}

TEST(ReadPly, ReadsBinaryOfBothByteOrders) {
  const std::string doubles = "property double x\nproperty double y\nproperty double z\n";
  const std::string little =
      bytesOf(0., 0., 0., 1., 0., 0., 0., 1., 0.5) + bytesOf(std::uint8_t{3}, 0, 1, 2);
  expectTheTriangle(meshOf("a.ply", header("binary_little_endian", doubles) + little));
  std::string big;
  for (const float value : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.5f}) big += swapped(value);
  big += swapped(std::int16_t{3}) + swapped(std::uint16_t{0}) + swapped(std::uint16_t{1}) +
         swapped(std::uint16_t{2});
  expectTheTriangle(
      meshOf("a.ply", header("binary_big_endian", kFloats, "short ushort vertex_index") + big));
}

TEST(ReadPly, ReadsEveryType) {
  struct Row {
    const char* type;
    std::string one;
    std::string zero;
  };
  const Row rows[] = {
      {"char", bytesOf(std::int8_t{-1}), bytesOf(std::int8_t{0})},
      {"int8", bytesOf(std::int8_t{-1}), bytesOf(std::int8_t{0})},
      {"int16", bytesOf(std::int16_t{-1}), bytesOf(std::int16_t{0})},
      {"int", bytesOf(-1), bytesOf(0)},
      {"float32", bytesOf(-1.f), bytesOf(0.f)},
      {"float64", bytesOf(-1.), bytesOf(0.)},
  };
  for (const Row& row : rows) {
    std::string properties;
    for (const char* const name : {"x", "y", "z"}) {
      properties.append("property ").append(row.type).append(" ").append(name).append("\n");
    }
    const std::string values = row.zero + row.zero + row.zero + row.one + row.zero + row.zero +
                               row.zero + row.one + row.zero;
    const TriangleMesh mesh = meshOf("a.ply", header("binary_little_endian", properties) + values +
                                                  bytesOf(std::uint8_t{3}, 0, 1, 2));
    EXPECT_EQ(mesh.vertices.col(1), Eigen::Vector3d(-1, 0, 0)) << row.type;
    EXPECT_EQ(mesh.vertices.col(2), Eigen::Vector3d(0, -1, 0)) << row.type;
  }
}

TEST(ReadPly, PassesOverOtherPropertiesAndElements) {
  expectTheTriangle(meshOf(
      "a.ply",
      "ply\nobj_info more\nformat ascii 1.0\n\nelement camera 1\nproperty list int float view\n"
      "element vertex 3\nproperty uchar red\nproperty float z\nproperty list uchar int x\n"
      "property float y\nproperty float x\nelement face 1\nproperty list uchar float uv\n"
      "property list uint uchar vertex_index\nproperty int flags\nelement nothing 0\nend_header\n"
      "2 7 8\n9 0 1 5 0 0\n9 0 0 0 1\n9 0.5 2 6 6 1 0\n2 0.5 0.5 3 0 1 2 4\n"));
}

TEST(ReadPly, FacesMayComeFirstAndHaveManyCorners) {
  const TriangleMesh mesh =
      meshOf("a.ply",
             "ply\nformat ascii 1.0\nelement face 1\nproperty list uchar int vertex_indices\n"
             "element vertex 4\n" +
                 kFloats + "end_header\n4 0 1 2 3\n0 0 0\n2 0 0\n2 1 0\n0 1 0\n");
  EXPECT_EQ(mesh.triangles.cols(), 2);
  EXPECT_NEAR(areaOf(mesh), 2, 1e-12);
}

TEST(ReadPly, NamesTheLineOfBrokenHeaders) {
  const auto problemWith = [](const std::string& old, const std::string& replacement) {
    return problemOf("a.ply", replaced(ascii(kRows), old, replacement));
  };
  EXPECT_EQ(problemWith("ply\n", "plx\n"), "a.ply:1: a PLY file must begin with ply");
  EXPECT_EQ(
      problemWith("ascii", "asci"),
      "a.ply:2: the format must be ascii, binary_little_endian or binary_big_endian, got \"asci\"");
  EXPECT_EQ(problemWith("vertex 3", "vertex -3"),
            "a.ply:4: the number of \"vertex\" must be an integer >= 0, got \"-3\"");
  EXPECT_EQ(
      problemWith("vertex 3", "vertex 99999999999999999999"),
      "a.ply:4: the number of \"vertex\" must be an integer >= 0, got \"99999999999999999999\"");
  EXPECT_EQ(problemWith("float y", "flout y"),
            "a.ply:6: a type must be char, uchar, short, ushort, int, uint, float or double, got "
            "\"flout\"");
  EXPECT_EQ(problemWith("list uchar", "list float"), "a.ply:9: a list's count must be integer");
  EXPECT_EQ(
      problemWith("comment", "commend"),
      "a.ply:3: format, element, property (after an element), comment, obj_info or end_header "
      "expected, got \"commend\"");
  EXPECT_EQ(problemWith("end_header\n" + kRows, ""),
            "a.ply:9: the header lacks the line end_header");
  EXPECT_EQ(problemWith("format ascii 1.0\n", ""), "a.ply:9: the header lacks the line format");
  EXPECT_EQ(problemWith("float z", "float w"), "a.ply: the element vertex lacks the property z");
  EXPECT_EQ(problemWith("vertex_indices", "corners"),
            "a.ply: the element face lacks the list property vertex_indices");
}

TEST(ReadPly, RefusesCountsThatTheFileCannotHold) {
  EXPECT_EQ(problemOf("a.ply", replaced(ascii(kRows), "vertex 3", "vertex 4000000000")),
            "a.ply:10: 4000000000 rows of \"vertex\" do not fit into the 28 bytes that are left of "
            "the file");
  EXPECT_EQ(problemOf("a.ply", replaced(ascii(kRows), "element face",
                                        "element none 9000000000\nelement face")),
            "a.ply:14: 9000000000 rows of \"none\" do not fit into the 8 bytes that are left of "
            "the file");
  const std::string vertices = bytesOf(0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f);
  const std::string problem =
      problemOf("a.ply", header("binary_little_endian", kFloats, "uint int vertex_indices") +
                             vertices + bytesOf(std::uint32_t{0x80000000}, 0, 1, 2));
  EXPECT_EQ(problem,
            "a.ply: byte 226: a list of \"vertex_indices\" must hold 0 to 3 values, as many as fit "
            "into the rest of the file, got 2147483648");
  EXPECT_EQ(problemOf("a.ply", header("binary_little_endian", kFloats, "char int vertex_indices") +
                                   vertices + bytesOf(std::int8_t{-1}, 0, 1, 2)),
            "a.ply: byte 223: a list of \"vertex_indices\" must hold 0 to 3 values, as many as fit "
            "into the rest of the file, got -1");
}

TEST(ReadPly, EveryTruncationIsAnError) {
  const std::string files[] = {ascii(kRows.substr(0, kRows.size() - 1)),
                               header("binary_little_endian", kFloats) +
                                   bytesOf(0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f) +
                                   bytesOf(std::uint8_t{3}, 0, 1, 2)};
  for (const std::string& file : files) {
    ASSERT_EQ(problemOf("a.ply", file), "");
    for (std::size_t size = 0; size < file.size(); ++size) {
      EXPECT_NE(problemOf("a.ply", std::string_view(file).substr(0, size)), "") << size;
    }
  }
}

TEST(ReadPly, RefusesBadRows) {
  EXPECT_EQ(problemOf("a.ply", ascii("0 0 0\n1 x 0\n0 1 0\n3 0 1 2\n")),
            "a.ply:12: a value must be a number, got \"x\"");
  EXPECT_EQ(problemOf("a.ply", ascii("0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n")),
            "a.ply: vertex 1: coordinates must be finite, got 1, nan, 0");
  EXPECT_EQ(problemOf("a.ply", ascii("0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n")),
            "a.ply: face 0: vertex 3 does not exist, there are 0 to 2");
  EXPECT_EQ(problemOf("a.ply", ascii("0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n")),
            "a.ply:14: a vertex index must be an integer >= 0, got -1");
  EXPECT_EQ(problemOf("a.ply", ascii(kRows + "3 0 1 2\n")),
            "a.ply:15: the file goes on behind its last value: the header's counts are wrong");
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(problemOf("a.ply", header("binary_little_endian", kFloats) +
                                   bytesOf(0.f, 0.f, 0.f, 1.f, nan, 0.f, 0.f, 1.f, 0.f) +
                                   bytesOf(std::uint8_t{3}, 0, 1, 2)),
            "a.ply: vertex 1: coordinates must be finite, got 1, nan, 0");
  EXPECT_EQ(problemOf("a.ply", replaced(ascii("0 0 0\n1 0 0\n0 1 0\n"), "face 1", "face 0")),
            "a.ply: holds 3 points but no faces: a point cloud must be meshed first");
}

TEST(ReadPly, PropertiesThatNobodyReadsMayBeAnything) {
  const std::string text = replaced(ascii("0 0 0 nan\n1 0 0 -1.#IND\n0 1 0.5 inf\n3 0 1 2\n"),
                                    "element face", "property float quality\nelement face");
  expectTheTriangle(meshOf("a.ply", text));
  EXPECT_NE(problemOf("a.ply", replaced(text, " inf", "")), "");
}

TEST(ReadPly, VerticesThatNoFaceUsesMayBeNoNumbers) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const std::string text =
      replaced(ascii("nan nan nan\n0 0 0\n1 0 0\n0 1 0.5\n3 1 2 3\n"), "vertex 3", "vertex 4");
  expectTheTriangle(meshOf("a.ply", text));
  expectTheTriangle(
      meshOf("a.ply", replaced(header("binary_little_endian", kFloats), "vertex 3", "vertex 4") +
                          bytesOf(nan, nan, nan, 0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.5f) +
                          bytesOf(std::uint8_t{3}, 1, 2, 3)));
}

TEST(ReadPly, TellsOfFacesOfFewerThanThreeCorners) {
  const std::string text = replaced(ascii(kRows + "2 0 1\n0\n"), "face 1", "face 3");
  expectTheTriangle(meshOf("a.ply", text));
  EXPECT_EQ(noticesOf("a.ply", text), "passed over 2 faces of fewer than three corners");
  EXPECT_EQ(noticesOf("a.ply", ascii(kRows)), "");
}

/// -1 ends a strip; every other triangle is turned, so that all face the same way.
TEST(ReadPly, ReadsTriangleStrips) {
  const std::string text = "ply\nformat ascii 1.0\nelement vertex 5\n" + kFloats +
                           "element tristrips 1\nproperty list int int vertex_indices\nend_header\n"
                           "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n10 0 1 2 3 4 -1 0 2 2 1\n";
  Eigen::Matrix3Xi triangles(3, 3);
  triangles << 0, 1, 2, 1, 3, 3, 2, 2, 4;
  EXPECT_EQ(meshOf("a.ply", text).triangles, triangles);
  EXPECT_EQ(problemOf("a.ply", replaced(text, "3 4 -1", "3 9 -1")),
            "a.ply: face 2: vertex 9 does not exist, there are 0 to 4");
  EXPECT_EQ(problemOf("a.ply", replaced(text, "3 4 -1", "3 4 -2")),
            "a.ply:15: a vertex index must be an integer >= 0, got -2");
}

TEST(ReadPly, NamesRangeGrids) {
  EXPECT_EQ(problemOf("a.ply", "ply\nformat ascii 1.0\nobj_info num_cols 2\nelement vertex 1\n" +
                                   kFloats +
                                   "element range_grid 2\nproperty list uchar int vertex_indices\n"
                                   "end_header\n0 0 0\n1 0\n0\n"),
            "a.ply: holds a range grid of 1 point, as a scanner sees them, but no faces: it must "
            "be meshed first");
}

TEST(ReadPly, ReadsTextWithAMark) {
  expectTheTriangle(meshOf("a.ply", "\xef\xbb\xbf" + ascii(kRows)));
}

}  // namespace
}  // namespace morphgrid
