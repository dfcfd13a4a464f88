#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/app/scene_files.h"

namespace morphgrid {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

TEST(SceneErrors, KeysOfAnotherKind) {
  const std::string otherThan = " belongs to surfaces of kind ";
  EXPECT_EQ(SceneFiles("[surface]\nkind = \"bezier\"\npatch = \"p.toml\"\ntheta_u = [0, 9]\n"
                       "theta_v = [0, 0]\nspacing = 1\n[grid]\nlayer_spacing = 1\nnodes_u = 1\n"
                       "nodes_v = \"a\"\n")
                .problems(),
            "scene.toml:4:11: surface.theta_u belongs to surfaces of kind \"bend_angles\", this "
            "one is \"bezier\"\n"
            "scene.toml:5:11: surface.theta_v belongs to surfaces of kind \"bend_angles\", this "
            "one is \"bezier\"\n"
            "scene.toml:6:11: surface.spacing belongs to surfaces of kind \"bend_angles\", this "
            "one is \"bezier\"\n"
            "scene.toml:9:11: grid.nodes_u belongs to surfaces of kind \"bend_angles\", this one "
            "is \"bezier\"\n"
            "scene.toml:10:11: grid.nodes_v belongs to surfaces of kind \"bend_angles\", this one "
            "is \"bezier\"");
  EXPECT_EQ(
      SceneFiles("surface = { kind = \"bend_angles\", patch = \"missing.toml\" }\n"
                 "[grid]\nlayer_spacing = 1\nnodes_u = 1\nnodes_v = 1\n"
                 "nodes_long = 0\nmax_shrinkage = 0.4\ncurvature_cutoff = 1\n")
          .problems(),
      "scene.toml:1:43: surface.patch belongs to surfaces of kind \"bezier\", this one is "
      "\"bend_angles\"\n"
      "scene.toml:6:14: grid.nodes_long belongs to surfaces of kind \"bezier\" or \"mesh\", this "
      "one is \"bend_angles\"\n"
      "scene.toml:8:20: grid.curvature_cutoff belongs to surfaces of kind \"bezier\" or \"mesh\", "
      "this one is \"bend_angles\"");
}

TEST(SceneErrors, MissingKeys) {
  EXPECT_EQ(
      SceneFiles("").problems(),
      "scene.toml:1:1: surface.kind is missing: it must be \"bezier\" or \"mesh\" or "
      "\"bend_angles\"\n"
      "scene.toml:1:1: grid.layer_spacing is missing: it must be a number >= 1e-30 and <= 1e+15");
  EXPECT_EQ(
      SceneFiles("\n[surface]\nkind = \"bezier\"\n\n  [grid]\n").problems(),
      "scene.toml:2:1: surface.patch is missing: it must be a string\n"
      "scene.toml:5:3: grid.layer_spacing is missing: it must be a number >= 1e-30 and <= 1e+15");
  EXPECT_EQ(SceneFiles("surface.kind = \"bend_angles\"\n[grid]\nlayer_spacing = 1\n").problems(),
            "scene.toml:2:1: grid.nodes_u is missing: it must be an integer >= 1 and <= "
            "2147483647\n"
            "scene.toml:2:1: grid.nodes_v is missing: it must be an integer >= 1 and <= "
            "2147483647");
}

TEST(SceneErrors, ASectionThatIsNoTableIsOneProblem) {
  EXPECT_EQ(SceneFiles("surface = 3\ngrid = \"\"\nmaterial = 1\n").problems(),
            "scene.toml:1:11: surface must be a table, got 3\n"
            "scene.toml:2:8: grid must be a table, got \"\"\n"
            "scene.toml:3:12: material must be a table, got 1");
}

TEST(SceneErrors, UnknownKeys) {
  expectMessages(
      kBezierScene,
      {
          {"layrs = 4", "scene.toml:6:1: unknown key grid.layrs; did you mean grid.layers?"},
          {"  nodes_lnog = 4",
           "scene.toml:6:3: unknown key grid.nodes_lnog; did you mean grid.nodes_long?"},
          {"tolerance = 4",
           "scene.toml:6:1: unknown key grid.tolerance; did you mean solver.tolerance?"},
          {"[wieghts]\nlateral = 0", "scene.toml:6:2: unknown key wieghts; did you mean weights?"},
          {"[[weigths]]\nlateral = 0",
           "scene.toml:6:3: unknown key weigths; did you mean weights?"},
      });
  EXPECT_EQ(SceneFiles("layers = 4\n" + std::string(kBezierScene)).problems(),
            "scene.toml:1:1: unknown key layers; did you mean grid.layers?");
}

TEST(SceneErrors, UnknownKeysThatResembleNoneAreToldWhatThereIs) {
  for (const auto& [name, shown] : {std::pair{"bananas", "bananas"}, {"\"a\\nb\"", "a\\x0ab"}}) {
    const std::string problems = SceneFiles(std::string(kBezierScene) + name + " = 4\n").problems();
    EXPECT_THAT(problems, StartsWith(std::string("scene.toml:6:1: unknown key grid.") + shown +
                                     "; known here: layers, "));
    EXPECT_THAT(problems, HasSubstr(", nodes_long, "));
    EXPECT_THAT(problems, testing::Not(HasSubstr("nodes_u"))) << "it is of another kind";
  }
}

TEST(SceneErrors, Kind) {
  EXPECT_EQ(SceneFiles("[surface]\nkind = \"nurbs\"\npatch = \"p.toml\"\ntheta_u = [0, 4]\n[grid]\n"
                       "layer_spacing = 1\nnodes_long = 4\nnodes_u = 3\n")
                .problems(),
            "scene.toml:2:8: surface.kind must be \"bezier\" or \"mesh\" or \"bend_angles\", got "
            "\"nurbs\"\n"
            "scene.toml:4:15: surface.theta_u[1] must be a number >= -pi and <= pi, got 4");
}

TEST(SceneErrors, Syntax) {
  struct SyntaxCase {
    const char* scene;
    const char* place;
  };
  const SyntaxCase cases[] = {
      {"[grid\n", "scene.toml:1:6: not valid TOML: "},
      {"a = 1\na = 2\n", "scene.toml:2:5: not valid TOML: "},
      {"[grid]\nlayers = \n", "scene.toml:2:10: not valid TOML: "},
      {"[grid]\nlayers = 01\n", "scene.toml:2:12: not valid TOML: "},
      {"[grid]\nlayers = 99999999999999999999\n", "scene.toml:2:30: not valid TOML: "},
      {"[grid]\n[grid]\n", "scene.toml:2:1: not valid TOML: "},
      {"title = \"\xff\"\n", "scene.toml:1:9: not valid TOML: "},
  };
  for (const SyntaxCase& bad : cases) {
    SCOPED_TRACE(bad.scene);
    EXPECT_THAT(SceneFiles(bad.scene).problems(),
                AllOf(StartsWith(bad.place), testing::Not(HasSubstr("\n"))));
  }
  EXPECT_EQ(SceneFiles("[grid]\nlayers = \n").problems(),
            "scene.toml:2:10: not valid TOML: while parsing key-value pair: expected value, saw "
            "'\\n'");
}

TEST(SceneErrors, UnreadableScenes) {
  const TemporaryFolder folder;
  const auto message = [&](const std::filesystem::path& file) -> std::string {
    try {
      loadScene(file);
    } catch (const InputError& error) {
      return folder.withoutPath(error.what());
    }
    return "";
  };
  EXPECT_EQ(message(folder.path() / "none.toml"),
            "none.toml: cannot be read: No such file or directory");
  folder.write("inner/file", "");
  EXPECT_EQ(message(folder.path() / "inner"), "inner: cannot be read: it is a folder");
}

TEST(SceneErrors, UnreadablePatches) {
  const std::string end = "\n[grid]\nlayer_spacing = 1\n";
  const std::string start = "[surface]\nkind = \"bezier\"\npatch = ";
  EXPECT_EQ(SceneFiles(start + "\"none.toml\"" + end).problems(),
            "scene.toml:3:9: surface.patch must name a readable file, got none.toml: No such file "
            "or directory");
  EXPECT_EQ(SceneFiles(start + "\".\"" + end).problems(),
            "scene.toml:3:9: surface.patch must name a readable file, got .: it is a folder");
  EXPECT_EQ(SceneFiles(start + "3" + end).problems(),
            "scene.toml:3:9: surface.patch must be a string, got 3");
}

TEST(SceneErrors, ProblemsOfThePatchComeWithThoseOfTheScene) {
  const SceneFiles files(std::string(kBezierScene) + "layers = 0\n", "control_points = 3\nx = 1\n");
  EXPECT_EQ(files.problems({"solver.tolerance=2"}),
            "scene.toml:6:10: grid.layers must be an integer >= 1 and <= 64, got 0\n"
            "--set solver.tolerance=2: solver.tolerance must be a number > 0 and < 1, got 2\n"
            "p.toml:1:18: control_points must be an array of 4 rows (along v), got 3\n"
            "p.toml:2:1: unknown key x; known here: control_points");
}

TEST(SceneErrors, AreListedInTheOrderOfTheFile) {
  EXPECT_EQ(
      SceneFiles(R"(titel = "x"
[output]
width = 1
[solver]
tolerance = "small"
[grid]
layers = 4.5
nodes_lnog = 1
[surface]
kind = "bezier"
patch = "none.toml"
)")
          .problems(),
      "scene.toml:1:1: unknown key titel; did you mean title?\n"
      "scene.toml:3:9: output.width must be an integer >= 64 and <= 8192, got 1\n"
      "scene.toml:5:13: solver.tolerance must be a number > 0 and < 1, got \"small\"\n"
      "scene.toml:6:1: grid.layer_spacing is missing: it must be a number >= 1e-30 and <= 1e+15\n"
      "scene.toml:7:10: grid.layers must be an integer >= 1 and <= 64, got 4.5\n"
      "scene.toml:8:1: unknown key grid.nodes_lnog; did you mean grid.nodes_long?\n"
      "scene.toml:11:9: surface.patch must name a readable file, got none.toml: No such "
      "file or directory");
}

}  // namespace
}  // namespace morphgrid
