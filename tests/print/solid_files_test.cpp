// STL and 3MF, read back by readers of their own.
#include "print/solid_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cstring>
#include <regex>

#include "tests/print/print_samples.h"
#include "tests/print/zip_reader.h"

namespace morphgrid {
namespace {

using testing::HasSubstr;
using testing::Not;

std::vector<SolidMesh> sampleSolids() {
  const PrintPlan plan = planPrint("solids", randomGrid({3, 3, 2}, 0, 0.3, 2), samplePrinter(),
                                   sampleMaterial(), {.scale = 14, .enlargement = 1.0});
  return {tierSolid(plan, 0), tierSolid(plan, 1)};
}

TEST(Stl, HoldsEveryTriangle) {
  const SolidMesh solid = sampleSolids()[0];
  const std::string bytes = stlOf(solid);
  ASSERT_EQ(bytes.size(), 84u + 50 * static_cast<std::size_t>(solid.triangles.cols()));
  EXPECT_NE(bytes.substr(0, 5), "solid");  // That would be the text format.
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + 80, 4);
  EXPECT_EQ(count, solid.triangles.cols());
  for (Eigen::Index n = 0; n < solid.triangles.cols(); ++n) {
    Eigen::Matrix<float, 3, 4> read;
    std::memcpy(read.data(), bytes.data() + 84 + 50 * n, 48);
    for (int corner = 0; corner < 3; ++corner) {
      EXPECT_EQ(read.col(corner + 1), solid.points.col(solid.triangles(corner, n)).cast<float>());
    }
    const Eigen::Vector3f a = read.col(2) - read.col(1), b = read.col(3) - read.col(1);
    EXPECT_GT(a.cross(b).dot(read.col(0)), 0);
  }
}

/// The numbers of an attribute, in a row.
std::vector<double> numbersOf(const std::string& text, const std::string& name) {
  std::vector<double> numbers;
  const std::regex attribute(" " + name + "=\"([^\"]*)\"");
  for (std::sregex_iterator match(text.begin(), text.end(), attribute), end; match != end;
       ++match) {
    numbers.push_back(std::stod((*match)[1]));
  }
  return numbers;
}

TEST(ThreeMf, IsAnObjectAndABuildItemATier) {
  const auto solids = sampleSolids();
  const auto files = readZip(threeMfOf(solids));
  EXPECT_THAT(files.at("_rels/.rels"), HasSubstr("Target=\"/3D/3dmodel.model\""));
  EXPECT_THAT(files.at("[Content_Types].xml"), HasSubstr("3dmanufacturing-3dmodel+xml"));
  const std::string& model = files.at("3D/3dmodel.model");
  EXPECT_THAT(model, HasSubstr("unit=\"millimeter\""));
  EXPECT_THAT(model, Not(HasSubstr("<component")));
  EXPECT_THAT(model, HasSubstr("name=\"tier 1\" type=\"model\""));
  EXPECT_THAT(model, HasSubstr("name=\"tier 2\" type=\"model\""));
  EXPECT_EQ(numbersOf(model, "objectid"), numbersOf(model, "id"));
  EXPECT_EQ(numbersOf(model, "id").size(), 2u);

  const auto x = numbersOf(model, "x"), y = numbersOf(model, "y"), z = numbersOf(model, "z");
  const auto a = numbersOf(model, "v1"), b = numbersOf(model, "v2"), c = numbersOf(model, "v3");
  std::size_t point = 0, triangle = 0;
  for (const SolidMesh& solid : solids) {
    for (const auto& expected : solid.points.colwise()) {
      ASSERT_LT(point, x.size());
      EXPECT_LT((Eigen::Vector3d(x[point], y[point], z[point]) - expected).norm(), 2e-5);
      ++point;
    }
    for (const auto& expected : solid.triangles.colwise()) {
      ASSERT_LT(triangle, a.size());
      EXPECT_EQ(Eigen::Vector3i(static_cast<int>(a[triangle]), static_cast<int>(b[triangle]),
                                static_cast<int>(c[triangle])),
                expected);
      ++triangle;
    }
  }
  EXPECT_EQ(point, x.size());
  EXPECT_EQ(triangle, a.size());
}

TEST(ThreeMf, TiersLieSideBySide) {
  const auto solids = sampleSolids();
  const std::string model = readZip(threeMfOf(solids)).at("3D/3dmodel.model");
  std::smatch match;
  ASSERT_TRUE(std::regex_search(model, match, std::regex("transform=\"([^\"]*)\"")));
  std::istringstream words(match[1]);
  std::vector<double> numbers;
  for (double number = 0; words >> number;) numbers.push_back(number);
  ASSERT_EQ(numbers.size(), 12u);
  const double width = solids[0].points.row(0).maxCoeff() - solids[0].points.row(0).minCoeff();
  EXPECT_NEAR(numbers[9], width + 10, 1e-3);  // Behind the matrix.
  EXPECT_EQ(numbers[10], 0);
  EXPECT_EQ(numbers[0], 1);
}

TEST(ThreeMf, IsTheSameEveryTime) {
  const auto solids = sampleSolids();
  EXPECT_EQ(threeMfOf(solids), threeMfOf(solids));
}

}  // namespace
}  // namespace morphgrid
