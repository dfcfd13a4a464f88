#include "surface/load_mesh.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <map>

#include "core/read_file.h"
#include "tests/fuzz/read_fuzzed_mesh.h"
#include "tests/support/folders.h"
#include "tests/support/shared_folder.h"
#include "tests/support/temporary_folder.h"
#include "tests/surface/mesh_files.h"

namespace morphgrid {
namespace {

using testing::StartsWith;

TEST(LoadMesh, ReadsFromTheDisk) {
  const TemporaryFolder folder;
  const TriangleMesh mesh =
      loadMesh(folder.write("a.Obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")).mesh;
  EXPECT_EQ(mesh.triangles, Eigen::Vector3i(0, 1, 2));
}

TEST(LoadMesh, TellsWhyAFileCannotBeRead) {
  const TemporaryFolder folder;
  const auto problemOfName = [&](const std::string& name) {
    return folder.withoutPath(problemOfFile(folder / name));
  };
  EXPECT_EQ(problemOfName("none.obj"), "none.obj: cannot be read: No such file or directory");
  std::filesystem::create_directory(folder / "folder.obj");
  EXPECT_EQ(problemOfName("folder.obj"), "folder.obj: cannot be read: it is a folder");
  ASSERT_EQ(mkfifo((folder / "pipe.obj").c_str(), 0600), 0);
  EXPECT_EQ(problemOfName("pipe.obj"), "pipe.obj: cannot be read: it is no regular file");
  folder.write("empty.obj", "");
  EXPECT_EQ(problemOfName("empty.obj"), "empty.obj: is empty");
  for (const std::string extension : {".fbx", ".bin", ""}) {
    folder.write("a" + extension, "some");
    EXPECT_EQ(problemOfName("a" + extension),
              "a" + extension + ": the extension must be .obj, .stl, .ply, .gltf or .glb, got \"" +
                  extension + "\"");
  }
}

TEST(LoadMesh, RefusesFilesOfMoreThanTwoGigabytes) {
  const TemporaryFolder folder;
  const auto file = folder.write("large.stl", "solid");
  std::filesystem::resize_file(file, 3'000'000'000);  // Sparse: takes no room.
  EXPECT_EQ(folder.withoutPath(problemOfFile(file)),
            "large.stl: must be of 2147483647 bytes at most, got 3000000000");
}

/// The messages of broken files are one printable line whatever the file holds.
TEST(LoadMesh, MessagesShowNoControlCharacters) {
  EXPECT_EQ(problemOf("a.obj", "v \x1b[31m\x80 0 0\n"),
            "a.obj:1: x must be a finite number, got \"?[31m?\"");
  EXPECT_EQ(problemOf("a.obj", "v " + std::string(1000, '1') + "x 0 0\n"),
            "a.obj:1: x must be a finite number, got \"" + std::string(32, '1') + "...\"");
}

/// What the fuzzer began with, and what it found.
TEST(LoadMesh, ReadsOrRefusesTheSeedsOfTheFuzzer) {
  int count = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(sourceFolder() / "tests/fuzz/seeds")) {
    SCOPED_TRACE(entry.path());
    EXPECT_NO_THROW(readFuzzedMesh(readFile(entry.path())));
    ++count;
  }
  EXPECT_GE(count, 20);
}

/// Triangles of a shared mesh, or what its error says behind the file's name.
struct Expected {
  int triangles;
  const char* problem;
};

void expectMeshes(const std::filesystem::path& folder,
                  const std::map<std::string, Expected>& expectations) {
  for (const auto& [name, expected] : expectations) {
    SCOPED_TRACE(name);
    if (expected.problem[0] != '\0') {
      EXPECT_THAT(problemOfFile(folder / name),
                  StartsWith((folder / name).string() + expected.problem));
    } else {
      EXPECT_NO_THROW(EXPECT_EQ(loadMesh(folder / name).mesh.triangles.cols(), expected.triangles));
    }
  }
}

TEST(LoadMesh, ReadsTheSharedMeshes) {
  const auto shared = sharedFolder();
  if (!shared) GTEST_SKIP() << "there are no shared meshes here";
  expectMeshes(*shared / "meshes", {{"mediapipe_canonical_face.obj", {898, ""}},
                                    {"hand_left.glb", {2314, ""}},
                                    {"gearwheel.stl", {2444, ""}},
                                    {"mh_male_head.obj", {8818, ""}},
                                    {"mh_male_torso.obj", {3738, ""}},
                                    {"spot_triangulated.obj", {5856, ""}},
                                    {"spot_control_mesh_quads.obj", {372, ""}},
                                    {"avocado/Avocado.gltf", {682, ""}},
                                    {"utah_teapot.stl", {9438, ""}},
                                    {"moebius_160_10.ply", {2880, ""}},
                                    {"featuretype.ply", {3476, ""}}});
}

TEST(LoadMesh, ReadsOddStlFilesAndRefusesBrokenOnes) {
  const auto shared = sharedFolder();
  if (!shared) GTEST_SKIP() << "there are no shared meshes here";
  expectMeshes(
      *shared / "meshes/stl_malformed",
      {
          // A name, a normal or a hole does not matter.
          {"missingFace.ascii.stl", {3, ""}},
          {"missingNormal.ascii.stl", {4, ""}},
          {"multiWordName.ascii.stl", {4, ""}},
          {"namelessSolid.ascii.stl", {4, ""}},
          {"notANumberNormal.ascii.stl", {4, ""}},
          {"singleFace.ascii.stl", {1, ""}},
          {"solidNameMismatch.ascii.stl", {4, ""}},
          {"tetrahedron.min.ascii.stl", {4, ""}},
          {"tetrahedronMinusZero.bin.stl", {4, ""}},
          {"wrongHeader.bin.stl", {12, ""}},
          {"wrongNormal.ascii.stl", {4, ""}},
          {"wrongNormals.ascii.stl", {4, ""}},
          // No shape.
          {"empty.stl", {0, ": is empty"}},
          {"faceless.ascii.stl", {0, ": holds no triangle"}},
          // STL holds triangles alone.
          {"fourVertices.ascii.stl",
           {0, ":7: after three vertices endloop expected, got \"vertex\""}},
          {"quad.ascii.stl", {0, ":7: after three vertices endloop expected, got \"vertex\""}},
          {"twoVertices.ascii.stl", {0, ":6: vertex expected, got \"endloop\""}},
          // Cut, or damaged on its way: nobody knows what is missing.
          {"missingEndsolid.ascii.stl",
           {0, ":29: facet or endsolid expected, got the end of the file"}},
          {"incorrectFaceCounter.bin.stl",
           {0,
            ": byte 80: a binary STL file with this number of facets takes 3384 bytes, got 284"}},
          {"multiWordName.bin.stl",
           {0, ": byte 85: the binary STL file was converted as if it were text"}},
      });
}

}  // namespace
}  // namespace morphgrid
