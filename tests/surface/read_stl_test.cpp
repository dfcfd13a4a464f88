#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <limits>

#include "tests/surface/mesh_files.h"

namespace morphgrid {
namespace {

const char* const kFacet =
    " facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n   vertex 1 0 0\n   vertex 0 1 0.5\n"
    "  endloop\n endfacet\n";

std::string solid(const std::string& facets, const std::string& name = "a name") {
  return "solid " + name + "\n" + facets + "endsolid " + name + "\n";
}

std::string binary(std::uint32_t facets, const std::string& content, const std::string& name = "") {
  std::string header = name;
  header.resize(80);
  return header + bytesOf(facets) + content;
}

std::string facetOf(float lastZ) {
  return bytesOf(0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, lastZ, std::uint16_t{0});
}

void expectTheFacet(const TriangleMesh& mesh) {
  ASSERT_GE(mesh.triangles.cols(), 1);
  EXPECT_EQ(mesh.vertices.col(mesh.triangles(1, 0)), Eigen::Vector3d(1, 0, 0));
  EXPECT_EQ(mesh.vertices.col(mesh.triangles(2, 0)), Eigen::Vector3d(0, 1, 0.5));
}

TEST(ReadStl, ReadsAscii) {
  expectTheFacet(meshOf("a.stl", solid(kFacet)));
  expectTheFacet(meshOf("a.STL", "\n  " + solid(kFacet, "")));
  EXPECT_EQ(meshOf("a.stl", solid(kFacet) + solid(std::string(kFacet) + kFacet)).triangles.cols(),
            3);
}

TEST(ReadStl, ReadsCapitals) {
  for (const char* const capitals : {"SOLID", "Solid", "solid"}) {
    std::string text = solid(kFacet);
    text.replace(0, 5, capitals);
    expectTheFacet(meshOf("a.stl", text));
    for (char& letter : text) letter = static_cast<char>(std::toupper(letter));
    expectTheFacet(meshOf("a.stl", text));
    EXPECT_EQ(problemOf("a.stl", text.substr(0, text.find("ENDLOOP"))),
              "a.stl:7: after three vertices endloop expected, got the end of the file");
  }
}

TEST(ReadStl, ReadsTextWithAMark) {
  expectTheFacet(meshOf("a.stl", "\xef\xbb\xbf" + solid(kFacet)));
  EXPECT_EQ(problemOf("a.stl", std::string("s\0o\0l\0i\0d\0", 10)),
            "a.stl: is UTF-16 text, which cannot be read: save it as UTF-8");
}

TEST(ReadStl, TellsOfBytesBehindTheFacets) {
  const std::string file = binary(2, facetOf(0.5) + facetOf(2));
  EXPECT_EQ(noticesOf("a.stl", file), "");
  expectTheFacet(meshOf("a.stl", file + "UNITS=mm"));
  EXPECT_EQ(noticesOf("a.stl", file + "UNITS=mm"),
            "passed over 8 bytes behind the 2 facets that the header counts");
}

TEST(ReadStl, RefusesBinaryFilesThatWereConvertedAsText) {
  std::string file = binary(1, facetOf(0.5));
  std::ranges::replace_if(
      file, [](char byte) { return byte < 0; }, '\0');
  file.replace(100, 1, "\xef\xbf\xbd");
  EXPECT_EQ(problemOf("a.stl", file),
            "a.stl: byte 100: the binary STL file was converted as if it were text: bytes of it "
            "were replaced by U+FFFD");
  file[110] = '\xbf';  // As in floats: what follows was no conversion's.
  EXPECT_EQ(noticesOf("a.stl", file),
            "passed over 2 bytes behind the 1 facet that the header counts");
}

TEST(ReadStl, ReadsBinary) {
  expectTheFacet(meshOf("a.stl", binary(2, facetOf(0.5) + facetOf(2))));
  expectTheFacet(meshOf("a.stl", binary(1, facetOf(0.5), "solid and yet binary")));
}

TEST(ReadStl, PassesOverNormals) {
  for (const char* const normal : {"normal nan nan nan", "normal 0 0 0", "normal", ""}) {
    std::string text = solid(kFacet);
    text.replace(text.find("normal 0 0 1"), 12, normal);
    expectTheFacet(meshOf("a.stl", text));
  }
}

TEST(ReadStl, NamesTheLineWhereTextBreaks) {
  const auto problemWith = [](const std::string& old, const std::string& replacement) {
    std::string text = solid(kFacet);
    text.replace(text.find(old), old.size(), replacement);
    return problemOf("a.stl", text);
  };
  EXPECT_EQ(problemWith("vertex 1 0 0", "vertex 1 zero 0"),
            "a.stl:5: y must be a finite number, got \"zero\"");
  EXPECT_EQ(problemWith("vertex 1 0 0", "vertex 1 nan 0"),
            "a.stl:5: y must be a finite number, got \"nan\"");
  EXPECT_EQ(problemWith("vertex 1 0 0", ""), "a.stl:7: vertex expected, got \"endloop\"");
  EXPECT_EQ(problemWith("endloop", "vertex 1 1 1\nendloop"),
            "a.stl:7: after three vertices endloop expected, got \"vertex\"");
  EXPECT_EQ(problemWith("endsolid a name\n", ""),
            "a.stl:8: facet or endsolid expected, got the end of the file");
  EXPECT_EQ(problemWith("  endloop\n endfacet\nendsolid a name\n", ""),
            "a.stl:6: after three vertices endloop expected, got the end of the file");
}

TEST(ReadStl, RefusesBinaryFilesOfAnotherSize) {
  const std::string two = facetOf(0) + facetOf(0);
  const std::string end = "; an ASCII one would begin with \"solid\"";
  EXPECT_EQ(
      problemOf("a.stl", binary(3, two)),
      "a.stl: byte 80: a binary STL file with this number of facets takes 234 bytes, got 184" +
          end);
  EXPECT_EQ(problemOf("a.stl", binary(0xffffffff, two)),
            "a.stl: byte 80: a binary STL file with this number of facets takes 214748364834 "
            "bytes, got 184" +
                end);
  EXPECT_EQ(
      problemOf("a.stl", binary(0, two)),
      "a.stl: byte 80: a binary STL file with this number of facets takes 84 bytes, got 184" + end);
  EXPECT_EQ(problemOf("a.stl", "PK"),
            "a.stl: byte 0: a binary STL file takes 84 bytes at least, got 2" + end);
}

TEST(ReadStl, NamesTheFacetThatIsNotFinite) {
  for (const float bad :
       {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    EXPECT_EQ(problemOf("a.stl", binary(2, facetOf(0) + facetOf(bad))),
              "a.stl: byte 146: facet 1: coordinates must be finite");
  }
}

TEST(ReadStl, RefusesNoFacets) {
  EXPECT_EQ(problemOf("a.stl", solid("")), "a.stl: holds no triangle");
  EXPECT_EQ(problemOf("a.stl", binary(0, "")), "a.stl: holds no triangle");
  EXPECT_EQ(problemOf("a.stl", ""), "a.stl: is empty");
}

}  // namespace
}  // namespace morphgrid
