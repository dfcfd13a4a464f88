#include "surface/read_patch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "tests/support/temporary_folder.h"

namespace morphgrid {
namespace {

const std::string kRow = "[[0, 0, 0], [1, 0, 1], [2, 0, 1], [3, 0, 0]],\n";

std::string patchOf(const std::string& row0) {
  return "control_points = [\n" + row0 + R"([[0, 1, 0], [1, 1, 1], [2, 1, 1], [3, 1, 0]],
[[0, 2, 0], [1, 2, 1], [2, 2, 1], [3, 2, 0]],
[[0, 3, 0], [1, 3, 1], [2, 3, 1], [3, 3, 0]],
]
)";
}

std::string problemsOf(const std::string& text) {
  const TemporaryFolder folder;
  try {
    readPatch(folder.write("p.toml", text));
  } catch (const InputError& error) {
    return folder.withoutPath(error.what());
  }
  return "";
}

TEST(ReadPatch, RowsRunAlongVAndColumnsAlongU) {
  const TemporaryFolder folder;
  const BezierPatch patch = readPatch(folder.write("p.toml", patchOf(kRow)));
  EXPECT_EQ(patch.controlPoints()[2][1], Eigen::Vector3d(1, 2, 1));
  EXPECT_EQ(patch.controlPoints()[0][3], Eigen::Vector3d(3, 0, 0));
  EXPECT_LT((patch.point(1, 0) - Eigen::Vector3d(3, 0, 0)).norm(), 1e-12);
  EXPECT_LT((patch.point(0, 1) - Eigen::Vector3d(0, 3, 0)).norm(), 1e-12);
}

TEST(ReadPatch, ReadsDecimalsExactly) {
  const TemporaryFolder folder;
  const std::string row = "[[0.1, -1e-3, 2.5], [1, 0, 1], [2, 0, 1], [3, 0, 148.407]],\n";
  const BezierPatch patch = readPatch(folder.write("p.toml", patchOf(row)));
  EXPECT_EQ(patch.controlPoints()[0][0], Eigen::Vector3d(0.1, -1e-3, 2.5));
  EXPECT_EQ(patch.controlPoints()[0][3].z(), 148.407);
}

TEST(ReadPatch, ReportsBadRowsPointsAndNumbers) {
  struct BadRow {
    const char* row;
    const char* message;
  };
  const BadRow cases[] = {
      {"3,\n", "p.toml:2:1: control_points[0] must be a row of 4 points (along u), got 3"},
      {"[[0, 0, 0], [1, 0, 1], [2, 0, 1]],\n",
       "p.toml:2:1: control_points[0] must be a row of 4 points (along u), got an array of 3"},
      {"[[0, 0, 0], [1, 0], [2, 0, 1], [3, 0, 0]],\n",
       "p.toml:2:13: control_points[0][1] must be a point of 3 numbers, [x, y, z], got an array of "
       "2"},
      {"[[0, 0, 0], 1, [2, 0, 1], [3, 0, 0]],\n",
       "p.toml:2:13: control_points[0][1] must be a point of 3 numbers, [x, y, z], got 1"},
      {"[[0, 0, nan], [1, 0, 1], [2, \"0\", 1], [-inf, 0, 0]],\n",
       "p.toml:2:9: control_points[0][0][2] must be a finite number, got nan\n"
       "p.toml:2:30: control_points[0][2][1] must be a finite number, got \"0\"\n"
       "p.toml:2:40: control_points[0][3][0] must be a finite number, got -inf"},
  };
  for (const BadRow& bad : cases) {
    SCOPED_TRACE(bad.row);
    EXPECT_EQ(problemsOf(patchOf(bad.row)), bad.message);
  }
}

TEST(ReadPatch, ReportsMissingRowsAndUnknownKeys) {
  EXPECT_EQ(problemsOf("control_points = [" + kRow + kRow + "]\n"),
            "p.toml:1:18: control_points must be an array of 4 rows (along v), got an array of 2");
  EXPECT_EQ(problemsOf(patchOf(kRow + kRow)),
            "p.toml:1:18: control_points must be an array of 4 rows (along v), got an array of 5");
  EXPECT_EQ(problemsOf(""),
            "p.toml:1:1: control_points is missing: it must be an array of 4 rows (along v)");
  EXPECT_EQ(problemsOf("control_point = 1\n"),
            "p.toml:1:1: control_points is missing: it must be an array of 4 rows (along v)\n"
            "p.toml:1:1: unknown key control_point; did you mean control_points?");
}

TEST(ReadPatch, ReportsWhatIsNoSurface) {
  const std::string row = "[[1, 1, 1], [1, 1, 1], [1, 1, 1], [1, 1, 1]],\n";
  EXPECT_THAT(problemsOf("control_points = [\n" + row + row + row + row + "]\n"),
              testing::StartsWith("p.toml:1:18: control_points: the patch has no area"));
}

TEST(ReadPatch, ReportsPointsTooFarAway) {
  const auto withCorner = [](const char* x) {
    return patchOf("[[" + std::string(x) + ", 0, 0], [1, 0, 1], [2, 0, 1], [3, 0, 0]],\n");
  };
  EXPECT_EQ(problemsOf(withCorner("1e3")), "");
  for (const char* x : {"1e+17", "-1e+30", "1e+300"}) {
    EXPECT_EQ(problemsOf(withCorner(x)),
              "p.toml:1:18: control_points: control point (row 0, column 0): each coordinate must "
              "be a number >= -1e+15 and <= 1e+15, got [" +
                  std::string(x) + ", 0, 0]");
  }
}

TEST(ReadPatch, ReportsSyntaxAndUnreadableFiles) {
  EXPECT_THAT(problemsOf("control_points = [\n"),
              testing::StartsWith("p.toml:1:20: not valid TOML: "));
  const TemporaryFolder folder;
  EXPECT_THROW(readPatch(folder.path() / "none.toml"), InputError);
  EXPECT_THROW(readPatch(folder.path()), InputError);
}

}  // namespace
}  // namespace morphgrid
