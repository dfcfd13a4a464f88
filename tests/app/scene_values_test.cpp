#include <gtest/gtest.h>

#include "tests/app/scene_files.h"

namespace morphgrid {
namespace {

TEST(SceneValues, GridOfAPatch) {
  expectMessages(
      kBezierScene,
      {
          {"layers = 0", "scene.toml:6:10: grid.layers must be an integer >= 1 and <= 64, got 0"},
          {"layers = 65", "scene.toml:6:10: grid.layers must be an integer >= 1 and <= 64, got 65"},
          {"  layers  =  3.0",
           "scene.toml:6:14: grid.layers must be an integer >= 1 and <= 64, got 3.0"},
          {"layers = \"3\"",
           "scene.toml:6:10: grid.layers must be an integer >= 1 and <= 64, got \"3\""},
          {"layers = true",
           "scene.toml:6:10: grid.layers must be an integer >= 1 and <= 64, got true"},
          {"layers = [1, 2]",
           "scene.toml:6:10: grid.layers must be an integer >= 1 and <= 64, got an array of 2"},
          {"layers = { n = 3 }",
           "scene.toml:6:10: grid.layers must be an integer >= 1 and <= 64, got a table"},
          {"layers = 2020-01-01",
           "scene.toml:6:10: grid.layers must be an integer >= 1 and <= 64, got a date or time"},
          {"nodes_long = 0",
           "scene.toml:6:14: grid.nodes_long must be an integer >= 1 and <= 2147483647, got 0"},
          {"nodes_long = 2147483648",
           "scene.toml:6:14: grid.nodes_long must be an integer >= 1 and <= 2147483647, got "
           "2147483648"},
          {"nodes_long = 400000000",
           "scene.toml:6:14: grid.nodes_long asks for too large a grid: at most 715827882 "
           "vertices are possible, got 2.4e+09"},
          {"max_shrinkage = 0",
           "scene.toml:6:17: grid.max_shrinkage must be a number > 0 and < 1, got 0"},
          {"max_shrinkage = 1.0",
           "scene.toml:6:17: grid.max_shrinkage must be a number > 0 and < 1, got 1.0"},
          {"max_shrinkage = nan",
           "scene.toml:6:17: grid.max_shrinkage must be a number > 0 and < 1, got nan"},
          {"curvature_cutoff = 0.0",
           "scene.toml:6:20: grid.curvature_cutoff must be a number > 0 and <= 1, got 0.0"},
          {"strut_thickness = 0",
           "scene.toml:6:19: grid.strut_thickness must be a number >= 1e-30 and <= 1e+15, got 0"},
          {"strut_thickness = inf",
           "scene.toml:6:19: grid.strut_thickness must be a number >= 1e-30 and <= 1e+15, got inf"},
          {"curvature_cutoff = 1.01",
           "scene.toml:6:20: grid.curvature_cutoff must be a number > 0 and <= 1, got 1.01"},
      });
}

TEST(SceneValues, OtherSections) {
  expectMessages(
      kBezierScene,
      {
          {"[weights]\nlateral = 0",
           "scene.toml:7:11: weights.lateral must be a number >= 1e-09 and <= 1e+09, got 0"},
          {"[weights]\nvertical = inf",
           "scene.toml:7:12: weights.vertical must be a number >= 1e-09 and <= 1e+09, got inf"},
          {"[weights]\nangle = -1e-3",
           "scene.toml:7:9: weights.angle must be a number >= 0 and <= 1e+09, got -0.001"},
          {"[weights]\nangle = -inf",
           "scene.toml:7:9: weights.angle must be a number >= 0 and <= 1e+09, got -inf"},
          {"[solver]\nmethod = \"jacobbi\"",
           "scene.toml:7:10: solver.method must be \"multigrid\" or \"jacobi\" or \"reference\", "
           "got \"jacobbi\""},
          {"[solver]\nmethod = 1",
           "scene.toml:7:10: solver.method must be \"multigrid\" or \"jacobi\" or \"reference\", "
           "got 1"},
          {"[solver]\nscaling = \"normalized\"",
           "scene.toml:7:11: solver.scaling must be \"normalised\" or \"shapeop\", got "
           "\"normalized\""},
          {"[solver]\ntolerance = 0",
           "scene.toml:7:13: solver.tolerance must be a number > 0 and < 1, got 0"},
          {"[solver]\ntolerance = 1",
           "scene.toml:7:13: solver.tolerance must be a number > 0 and < 1, got 1"},
          {"[solver]\nsmallest_eigenvalue = 1",
           "scene.toml:7:23: solver.smallest_eigenvalue must be true or false, got 1"},
          {"[solver]\niteration_limit = -1",
           "scene.toml:7:19: solver.iteration_limit must be an integer >= 0, got -1"},
          {"[output]\npictures = 1",
           "scene.toml:7:12: output.pictures must be true or false, got 1"},
          {"[output]\nwidth = 63",
           "scene.toml:7:9: output.width must be an integer >= 64 and <= 8192, got 63"},
          {"[output]\nheight = 8193",
           "scene.toml:7:10: output.height must be an integer >= 64 and <= 8192, got 8193"},
          {"[output]\nobj = \"yes\"",
           "scene.toml:7:7: output.obj must be true or false, got \"yes\""},
          {"[paper]\nfigure = 4", "scene.toml:7:10: paper.figure must be a string, got 4"},
          {"[paper]\nlongest_isoline_u = 0",
           "scene.toml:7:21: paper.longest_isoline_u must be a number > 0, got 0"},
          {"[paper]\nnodes_v = 2.5",
           "scene.toml:7:11: paper.nodes_v must be an integer >= 1 and <= 2147483647, got 2.5"},
          {"[paper]\nl0_percent = -1",
           "scene.toml:7:14: paper.l0_percent must be a number >= 0, got -1"},
          {"[[paper]]\nfigure = \"Fig. 4\"",
           "scene.toml:6:1: paper must be a table, got an array of 1"},
      });
}

TEST(SceneValues, BendAngles) {
  const std::string start = "surface = { kind = \"bend_angles\" ";
  const std::string end = "}\ngrid = { layer_spacing = 0.1, nodes_u = 4, nodes_v = 3 }\n";
  const std::vector<BadCase> cases = {
      {"theta_u = 1",
       "scene.toml:1:46: surface.theta_u must be [first, last], each a number >= -pi and <= pi, "
       "got "
       "1"},
      {"theta_u = [1]",
       "scene.toml:1:46: surface.theta_u must be [first, last], each a number >= -pi and <= pi, "
       "got "
       "an array of 1"},
      {"theta_v = [1, 3.15]",
       "scene.toml:1:50: surface.theta_v[1] must be a number >= -pi and <= pi, got 3.15"},
      {"theta_v = [\"1\", nan]",
       "scene.toml:1:47: surface.theta_v[0] must be a number >= -pi and <= pi, got \"1\"\n"
       "scene.toml:1:52: surface.theta_v[1] must be a number >= -pi and <= pi, got nan"},
      {"spacing = 0",
       "scene.toml:1:46: surface.spacing must be a number >= 1e-30 and <= 1e+15, got 0"},
  };
  for (const BadCase& bad : cases) {
    SCOPED_TRACE(bad.appended);
    EXPECT_EQ(SceneFiles(start + ", " + bad.appended + end).problems(), bad.message);
  }
}

TEST(SceneValues, BeyondWhatTheDeviceCanReckonWith) {
  expectMessages(
      kBendAnglesScene,
      {
          {"strut_thickness = 1e16",
           "scene.toml:7:19: grid.strut_thickness must be a number >= 1e-30 and <= 1e+15, got "
           "1e+16"},
          {"[weights]\nlateral = 1e308",
           "scene.toml:8:11: weights.lateral must be a number >= 1e-09 and <= 1e+09, got 1e+308"},
          {"[weights]\nvertical = 1e-20",
           "scene.toml:8:12: weights.vertical must be a number >= 1e-09 and <= 1e+09, got 1e-20"},
          {"[weights]\nangle = 1e20",
           "scene.toml:8:9: weights.angle must be a number >= 0 and <= 1e+09, got 1e+20"},
      });
  EXPECT_EQ(SceneFiles(kBendAnglesScene).problems({"grid.layer_spacing=1e-300"}),
            "--set grid.layer_spacing=1e-300: grid.layer_spacing must be a number >= 1e-30 and <= "
            "1e+15, got 1e-300");
}

TEST(SceneValues, TooManyVertices) {
  const std::string start = "[surface]\nkind = \"bend_angles\"\n[grid]\nlayer_spacing = 1\n";
  EXPECT_EQ(SceneFiles(start + "layers = 1\nnodes_u = 26753\nnodes_v = 26753\n").problems(), "");
  EXPECT_EQ(SceneFiles(start + "layers = 1\nnodes_u = 26754\nnodes_v = 26754\n").problems(),
            "scene.toml:6:11: grid.nodes_u asks for too large a grid: at most 715827882 vertices "
            "are possible, got 7.158e+08");
  EXPECT_EQ(SceneFiles(start + "nodes_u = 1\nnodes_v = 2147483647\n").problems(),
            "scene.toml:6:11: grid.nodes_v asks for too large a grid: at most 715827882 vertices "
            "are possible, got 1.288e+10");
}

}  // namespace
}  // namespace morphgrid
