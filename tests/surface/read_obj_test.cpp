#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/surface/mesh_files.h"

namespace morphgrid {
namespace {

const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

std::string problemOfObj(const std::string& text) { return problemOf("a.obj", text); }

TEST(ReadObj, ReadsVerticesAndFaces) {
  const TriangleMesh mesh = meshOf("a.obj", "v 0 0 0.5\nv 1.25e0 +2 -0\nv .5 3 -1E-2\nf 1 2 3\n");
  EXPECT_EQ(mesh.triangles, Eigen::Vector3i(0, 1, 2));
  EXPECT_EQ(mesh.vertices.col(1), Eigen::Vector3d(1.25, 2, 0));
  EXPECT_NEAR(mesh.vertices(2, 2), -0.01, 1e-17);
}

TEST(ReadObj, ReadsAllKindsOfCorners) {
  for (const char* const face : {"1 2 3", "1/1 2/1 3/1", "1//1 2//1 3//1", "1/1/1 2/1/1 3/1/1",
                                 "-4 -3 -2", "  1\t2  3  ", "1 2 3\r"}) {
    const TriangleMesh mesh =
        meshOf("a.obj", kSquare + "vt 0 0\nvn 0 0 1\nf " + std::string(face) + "\n");
    EXPECT_EQ(mesh.triangles, Eigen::Vector3i(0, 1, 2)) << face;
  }
}

TEST(ReadObj, NegativeIndicesCountBackFromTheFace) {
  const TriangleMesh mesh =
      meshOf("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 0 0 1\nf -4 -3 -1\n");
  EXPECT_EQ(mesh.triangles.col(0), Eigen::Vector3i(0, 1, 2));
  EXPECT_EQ(mesh.triangles.col(1), Eigen::Vector3i(0, 1, 3));
}

TEST(ReadObj, CutsPolygonsIntoTriangles) {
  const TriangleMesh mesh = meshOf("a.obj", kSquare + "f 1 2 3 4\n");
  EXPECT_EQ(mesh.triangles.cols(), 2);
  EXPECT_NEAR(areaOf(mesh), 1, 1e-12);
}

TEST(ReadObj, PassesOverTheRest) {
  const std::string rest =
      "# v nonsense\n\n   \nmtllib none.mtl\no a name\ng a b\ns off\nusemtl gold\nl 1 2\nvp 1\n"
      "t tag 9999/9999/9999\n";
  const std::string text = rest + kSquare + rest + "f 1 2 3";
  for (const char* const end : {"\n", "\r\n", "\r"}) {
    EXPECT_EQ(meshOf("a.obj", withLineEnds(text, end)).triangles.cols(), 1);
  }
}

TEST(ReadObj, NamesTheLineOfWhatIsNoNumber) {
  EXPECT_EQ(problemOfObj("# one\nv 0 0\n"), "a.obj:2: z must be a finite number, got nothing");
  EXPECT_EQ(problemOfObj("v 0 x1 0\n"), "a.obj:1: y must be a finite number, got \"x1\"");
  EXPECT_EQ(problemOfObj("v 0 0 0\r\nv nan 0 0\n"),
            "a.obj:2: x must be a finite number, got \"nan\"");
  EXPECT_EQ(problemOfObj("v 0 0 0\rv 0 0 -inf\n"),
            "a.obj:2: z must be a finite number, got \"-inf\"");
  EXPECT_EQ(problemOfObj("v 1e999 0 0\n"), "a.obj:1: x must be a finite number, got \"1e999\"");
  EXPECT_EQ(problemOfObj("v 1.5f 0 0\n"), "a.obj:1: x must be a finite number, got \"1.5f\"");
}

TEST(ReadObj, RefusesBadFaces) {
  for (const char* const corner : {"0", "x", "2.5", "4294967297", "/1", "1/2/3/4", "\\"}) {
    EXPECT_EQ(
        problemOfObj(kSquare + "f 1 2 " + corner + "\n"),
        "a.obj:5: a vertex of a face must be an integer other than 0, alone or as i/t, i//n or "
        "i/t/n, got \"" +
            std::string(corner) + "\"");
  }
  EXPECT_EQ(problemOfObj(kSquare + "f 1 2 3\nf 1 2 5\n"),
            "a.obj: face 2: vertex 5 does not exist, there are 1 to 4");
  EXPECT_EQ(problemOfObj(kSquare + "f 1 2 -5\n"),
            "a.obj: face 1: vertex 0 does not exist, there are 1 to 4");
}

TEST(ReadObj, RefusesFacesOfTooManyVertices) {
  std::string face = "f";
  for (int n = 0; n < 4097; ++n) face += " 1";
  EXPECT_EQ(problemOfObj(kSquare + face), "a.obj:5: a face must have 3 to 4096 vertices, got 4097");
}

TEST(ReadObj, TellsOfFacesOfFewerThanThreeCorners) {
  const std::string text = kSquare + "f 1\nf 1 2\nf\nf 1 2 3\n";
  EXPECT_EQ(meshOf("a.obj", text).triangles, Eigen::Vector3i(0, 1, 2));
  EXPECT_EQ(noticesOf("a.obj", text), "passed over 3 faces of fewer than three corners");
}

TEST(ReadObj, PassesOverTheMarkOfUtf8) {
  const std::string pyramid = "v -1 0 0\nv 0 -1 -1\nv 0 1 -1\nv 0 1 1\nv 9 9 9\nf 1 2 3\nf 1 3 4\n";
  const TriangleMesh mesh = meshOf("a.obj", "\xef\xbb\xbf" + pyramid);
  EXPECT_EQ(mesh.vertices, meshOf("a.obj", pyramid).vertices);
  EXPECT_EQ(boundingBox(mesh).min().x(), -1);
}

TEST(ReadObj, RefusesUtf16) {
  const std::string problem = "a.obj: is UTF-16 text, which cannot be read: save it as UTF-8";
  EXPECT_EQ(problemOfObj(std::string("\xff\xfe#\0", 4)), problem);
  EXPECT_EQ(problemOfObj(std::string("\xfe\xff\0#", 4)), problem);
  EXPECT_EQ(problemOfObj(std::string("v\0 \0"
                                     "1\0",
                                     6)),
            problem);
  EXPECT_EQ(problemOfObj(std::string("\0v\0 \0"
                                     "1",
                                     6)),
            problem);
}

TEST(ReadObj, ContinuesLinesBehindABackslash) {
  const std::string plain = kSquare + "f 1//1 2//2 3//3\n";
  for (const char* const end : {"\n", "\r\n", "\r"}) {
    const std::string text =
        "# no continuation \\\nv 0 \\\n0 \\ \n\\\n 0\nv 1 0 0\\\n\nv 1 1 0 # nor here \\\n"
        "g a \\\nf 1 2\nv 0 1 0\nf 1//1 \\\n2//2\\\n3//3\n";
    const TriangleMesh mesh = meshOf("a.obj", withLineEnds(text, end));
    EXPECT_EQ(mesh.vertices, meshOf("a.obj", plain).vertices);
    EXPECT_EQ(mesh.triangles, Eigen::Vector3i(0, 1, 2));
  }
  EXPECT_EQ(problemOfObj("v 1 \\\n 2 \\\n x\n"), "a.obj:3: z must be a finite number, got \"x\"");
}

TEST(ReadObj, PassesOverCommentsBehindStatements) {
  const TriangleMesh mesh =
      meshOf("a.obj", "v 0 0 0#a\nv 1 0 0 # b\nv 1 1 0 #\nf 1 2 3 # tri\nf 1 2 3# 4 5\n");
  EXPECT_EQ(mesh.vertices.col(1), Eigen::Vector3d(1, 0, 0));
  EXPECT_EQ(mesh.triangles.cols(), 2);
  EXPECT_EQ(problemOfObj("v 0 0 # 0\n"), "a.obj:1: z must be a finite number, got nothing");
}

TEST(ReadObj, NamesFreeFormGeometry) {
  const std::string surface = "cstype rat bezier\ndeg 1 1\nsurf 0 1 0 1 1 2 3 4\nparm u 0 1\nend\n";
  EXPECT_EQ(problemOfObj(kSquare + surface),
            "a.obj:7: free-form geometry (bezier) cannot be read: export it as a mesh of polygons, "
            "or write the 16 points of one bicubic patch into a patch file");
  EXPECT_EQ(noticesOf("a.obj", kSquare + surface + "f 1 2 3\n"),
            "free-form geometry (bezier), from line 7 on, was passed over");
}

TEST(ReadObj, RefusesAMeshWithoutTriangles) {
  EXPECT_EQ(problemOfObj(kSquare),
            "a.obj: holds 4 points but no faces: a point cloud must be meshed first");
  EXPECT_EQ(problemOfObj("PK\3\4 no mesh at all"), "a.obj: holds no triangle");
}

}  // namespace
}  // namespace morphgrid
