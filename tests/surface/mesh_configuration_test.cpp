#include "surface/mesh_configuration.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/error.h"
#include "tests/support/temporary_folder.h"

namespace morphgrid {
namespace {

/// Beside a file m.obj.
MeshConfiguration configurationOf(const std::string& text) {
  const TemporaryFolder folder;
  folder.write("meshes/m.obj", "");
  return readMeshConfiguration(folder.write("m.toml", "mesh = \"meshes/m.obj\"\n" + text));
}

std::string problemsOf(const std::string& text, const std::string& name = "m.toml") {
  const TemporaryFolder folder;
  folder.write("m.obj", "");
  try {
    readMeshConfiguration(folder.write(name, text));
  } catch (const InputError& error) {
    return folder.withoutPath(error.what());
  }
  return "";
}

std::string problemsOfTransforms(const std::string& transforms) {
  return problemsOf("mesh = \"m.obj\"\ntransforms = " + transforms + "\n");
}

Eigen::Vector3d moved(const std::string& transforms, const Eigen::Vector3d& point) {
  return configurationOf(transforms).worldFromMesh * point;
}

TEST(MeshConfiguration, DefaultsToTheMeshAsItIs) {
  const MeshConfiguration mesh = configurationOf("");
  EXPECT_TRUE(mesh.worldFromMesh.matrix().isIdentity(0));
  EXPECT_EQ(mesh.samplesU, 100);
  EXPECT_EQ(mesh.samplesV, 100);
  EXPECT_EQ(mesh.subdivisions, 0);
}

TEST(MeshConfiguration, ReadsEveryKey) {
  const TemporaryFolder folder;
  folder.write("meshes/m.obj", "");
  const MeshConfiguration mesh = readMeshConfiguration(folder.write(
      "m.toml", "mesh = \"meshes/m.obj\"\nsamples_u = 4\nsamples_v = 4096\nsubdivisions = 2\n"));
  EXPECT_EQ(mesh.mesh, folder / "meshes/m.obj");
  EXPECT_EQ(mesh.samplesU, 4);
  EXPECT_EQ(mesh.samplesV, 4096);
  EXPECT_EQ(mesh.subdivisions, 2);
}

TEST(MeshConfiguration, RotatesByTheRightHandAboutAnAxisOfAnyLength) {
  const Eigen::Vector3d point(1, 2, 3);
  const std::string turned = "transforms = [{rotate = {axis = [0, 1e-200, 0], degrees = -90}}]";
  EXPECT_LT((moved(turned, point) - Eigen::Vector3d(-3, 2, 1)).norm(), 1e-15);
  const std::string third = "transforms = [{rotate = {axis = [1, 1, 1], degrees = 120}}]";
  EXPECT_LT((moved(third, point) - Eigen::Vector3d(3, 1, 2)).norm(), 1e-14);
}

TEST(MeshConfiguration, ScalesEvenlyOrByAxis) {
  EXPECT_EQ(moved("transforms = [{scale = 2}]", {1, 2, 3}), Eigen::Vector3d(2, 4, 6));
  EXPECT_EQ(moved("transforms = [{scale = [2, 3, 0.5]}]", {1, 2, 3}), Eigen::Vector3d(2, 6, 1.5));
}

TEST(MeshConfiguration, AppliesTheFirstTransformFirst) {
  EXPECT_EQ(moved("transforms = [{translate = [1, 0, 0]}, {scale = 10}]", {1, 2, 3}),
            Eigen::Vector3d(20, 20, 30));
  EXPECT_EQ(moved("transforms = [{scale = 10}, {translate = [1, 0, 0]}]", {1, 2, 3}),
            Eigen::Vector3d(11, 20, 30));
  EXPECT_LT((moved("[[transforms]]\nrotate = {axis = [0, 0, 1], degrees = 90}\n"
                   "[[transforms]]\nscale = [2, 1, 1]\n[[transforms]]\ntranslate = [0, 0, 5]\n",
                   {1, 2, 3}) -
             Eigen::Vector3d(-4, 1, 8))
                .norm(),
            1e-14);
}

TEST(MeshConfiguration, ReportsMissingMeshesWithAHint) {
  EXPECT_EQ(problemsOf(""), "m.toml:1:1: mesh is missing: it must be a string");
  EXPECT_EQ(problemsOf("mesh = \"n.obj\"\n"),
            "m.toml:1:8: mesh must name a readable file, got n.obj: No such file or directory "
            "(if it belongs to scenes/, tools/run makes it)");
  EXPECT_EQ(problemsOf("mesh = \".\"\n"),
            "m.toml:1:8: mesh must name a readable file, got .: it is a folder");
}

TEST(MeshConfiguration, OfAMeshTakesItAsItIs) {
  EXPECT_EQ(readMeshConfiguration("some/bowl.OBJ"), MeshConfiguration{.mesh = "some/bowl.OBJ"});
}

TEST(MeshConfiguration, ReportsBadTransforms) {
  struct BadTransforms {
    const char* transforms;
    const char* message;
  };
  const BadTransforms cases[] = {
      {"{scale = 2}",
       "14: transforms must be an array of tables, each of rotate, scale or translate, got a "
       "table"},
      {"[2]", "15: transforms[0] must be a table, got 2"},
      {"[{scale = 1}, {}]",
       "28: transforms[1] must hold one of rotate, scale and translate, got 0"},
      {"[{scale = 1, translate = [1, 2, 3]}]",
       "15: transforms[0] must hold one of rotate, scale and translate, got 2"},
      {"[{scale = 0}]", "24: transforms[0].scale must be a number > 0, got 0"},
      {"[{scale = [1, -1, 1]}]", "28: transforms[0].scale[1] must be a number > 0, got -1"},
      {"[{scale = [1, 1]}]",
       "24: transforms[0].scale must be a number > 0 or 3 of them, [x, y, z], got an array of 2"},
      {"[{translate = [1, nan, inf]}]",
       "32: transforms[0].translate[1] must be a finite number, got nan\n"
       "m.toml:2:37: transforms[0].translate[2] must be a finite number, got inf"},
      {"[{rotate = 90}]", "25: transforms[0].rotate must be a table of axis and degrees, got 90"},
      {"[{rotate = {axis = [0, 0, 0], degrees = 90}}]",
       "33: transforms[0].rotate.axis must have a direction, got [0, 0, 0]"},
      {"[{rotate = {}}]",
       "25: transforms[0].rotate.axis is missing: it must be 3 numbers, [x, y, z]\n"
       "m.toml:2:25: transforms[0].rotate.degrees is missing: it must be a finite number"},
      {"[{scale = 1e300}, {scale = 1e300}]",
       "14: transforms must neither overflow nor flatten the mesh, taken together"},
      {"[{scale = 1e-200}, {scale = 1e-200}]",
       "14: transforms must neither overflow nor flatten the mesh, taken together"},
  };
  for (const BadTransforms& bad : cases) {
    SCOPED_TRACE(bad.transforms);
    EXPECT_EQ(problemsOfTransforms(bad.transforms), std::string("m.toml:2:") + bad.message);
  }
}

TEST(MeshConfiguration, ReportsUnknownKeysAtEveryDepth) {
  EXPECT_EQ(problemsOf("mesh = \"m.obj\"\nsample_u = 8\n"
                       "transforms = [{scale = 1, by = 2},\n"
                       "{rotate = {axis = [0, 0, 1], degree = 90}}]\n"),
            "m.toml:2:1: unknown key sample_u; did you mean samples_u?\n"
            "m.toml:3:27: unknown key transforms[0].by; known here: rotate, scale, translate\n"
            "m.toml:4:11: transforms[1].rotate.degrees is missing: it must be a finite number\n"
            "m.toml:4:30: unknown key transforms[1].rotate.degree; did you mean "
            "transforms[1].rotate.degrees?");
}

TEST(MeshConfiguration, ReportsCountsOutOfRangeAllAtOnce) {
  EXPECT_EQ(problemsOf("mesh = 1\nsamples_u = 3\nsamples_v = 5000\nsubdivisions = -1\n"),
            "m.toml:1:8: mesh must be a string, got 1\n"
            "m.toml:2:13: samples_u must be an integer >= 4 and <= 4096, got 3\n"
            "m.toml:3:13: samples_v must be an integer >= 4 and <= 4096, got 5000\n"
            "m.toml:4:16: subdivisions must be an integer >= 0 and <= 10, got -1");
}

}  // namespace
}  // namespace morphgrid
