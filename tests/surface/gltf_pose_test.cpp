#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>

#include "tests/surface/gltf_squares.h"
#include "tests/surface/mesh_files.h"

namespace morphgrid {
namespace {

using Eigen::Vector3d;
using nlohmann::json;
using testing::HasSubstr;

/// An accessor of the square, flat, whose corners 1 and 3 are raised by sparse values.
struct SparseSquare {
  json gltf = square();
  std::string bytes = squareBytes();

  SparseSquare() {
    const int indices = addAccessor(gltf, bytes, bytesOf<std::uint16_t, std::uint16_t>(1, 3),
                                    "SCALAR", kUnsignedShort, 2);
    const int values =
        addAccessor(gltf, bytes, bytesOf(1.f, 0.f, 5.f, 1.f, 1.f, 5.f), "VEC3", kFloat, 2);
    gltf["accessors"][0]["sparse"] = {
        {"count", 2},
        {"indices", {{"bufferView", indices}, {"componentType", kUnsignedShort}}},
        {"values", {{"bufferView", values}}}};
  }
};

TEST(GltfSparse, ReplacesElements) {
  const SparseSquare sparse;
  const TriangleMesh mesh = meshOfGltf(sparse.gltf, sparse.bytes);
  EXPECT_EQ(mesh.vertices.row(2), Eigen::RowVector4d(0, 5, 0, 5));
  EXPECT_EQ(mesh.vertices.col(2), Vector3d(0, 1, 0));
}

TEST(GltfSparse, ReplacesZerosWithoutABufferView) {
  SparseSquare sparse;
  sparse.gltf["accessors"][0].erase("bufferView");
  const TriangleMesh mesh = meshOfGltf(sparse.gltf, sparse.bytes);
  EXPECT_EQ(mesh.vertices.col(1), Vector3d(1, 0, 5));
  EXPECT_EQ(mesh.vertices.col(2), Vector3d(0, 0, 0));
}

TEST(GltfSparse, IndicesMayHaveNoBufferViewEither) {
  json gltf = square();
  std::string bytes = squareBytes();
  addAccessor(gltf, bytes, bytesOf<std::uint16_t, std::uint16_t>(1, 2), "SCALAR", kUnsignedShort,
              2);
  gltf["accessors"].erase(2);
  json& indices = gltf["accessors"][1];
  indices.erase("bufferView");
  indices["count"] = 3;
  const json part = {{"bufferView", 2}, {"componentType", kUnsignedShort}};
  indices["sparse"] = {{"count", 2}, {"indices", part}, {"values", part}};
  EXPECT_EQ(meshOfGltf(gltf, bytes).triangles, Eigen::Vector3i(0, 1, 2));
  indices.erase("sparse");
  EXPECT_EQ(meshOfGltf(gltf, bytes).triangles, Eigen::Vector3i(0, 0, 0));
  gltf["accessors"][0]["bufferView"] = 3;  // One that was there for a while.
  EXPECT_EQ(problemOfGltf(gltf, bytes),
            "a.glb: buffer view 3 does not exist, there are 3 (counted from 0)");
}

TEST(GltfSparse, RefusesWhatIsOutOfRange) {
  struct Case {
    const char* place;
    json value;
    const char* message;
  };
  const Case cases[] = {
      {"/sparse/count", 3,
       "a.glb: accessor 0, sparse: 3 elements, its buffer view holds 2 from byte 0 on"},
      {"/sparse/count", 2'000'000'000,
       "a.glb: accessor 0, sparse: 2000000000 elements, its buffer view holds 2 from byte 0 on"},
      {"/sparse/count", -1, "a.glb: accessor 0, sparse: count and byte offsets must be >= 0"},
      {"/sparse/values/byteOffset", 4,
       "a.glb: accessor 0, sparse: 2 elements, its buffer view holds 1 from byte 4 on"},
      {"/sparse/indices/bufferView", 9,
       "a.glb: buffer view 9 does not exist, there are 4 (counted from 0)"},
      {"/sparse/indices/componentType", kFloat,
       "a.glb: accessor 0, sparse: indices must be SCALAR, unsigned bytes, shorts or ints"},
      {"/count", 3, "a.glb: accessor 0, sparse: element 3 does not exist, there are 3"},
  };
  for (const Case& bad : cases) {
    SparseSquare sparse;
    sparse.gltf["accessors"][0][json::json_pointer(bad.place)] = bad.value;
    EXPECT_EQ(problemOfGltf(sparse.gltf, sparse.bytes), bad.message) << bad.place;
  }
}

/// No buffer backs them: only the file's size bounds them.
TEST(GltfSparse, RefusesMoreZerosThanTheFileExplains) {
  for (const std::uint64_t count : {std::uint64_t{100'000'000}, ~std::uint64_t{0}}) {
    SparseSquare sparse;
    sparse.gltf["accessors"][0].erase("bufferView");
    sparse.gltf["accessors"][0]["count"] = count;
    EXPECT_EQ(problemOfGltf(sparse.gltf, sparse.bytes),
              "a.glb: has more values read, or its meshes repeated more often, than can be held in "
              "memory");
  }
}

/// The square with two targets: the first lifts all corners by 1, the second moves them by 2 in x.
struct MorphSquare {
  json gltf = square();
  std::string bytes = squareBytes();

  MorphSquare() {
    const int lift = addAccessor(
        gltf, bytes, bytesOf(0.f, 0.f, 1.f, 0.f, 0.f, 1.f, 0.f, 0.f, 1.f, 0.f, 0.f, 1.f), "VEC3",
        kFloat, 4);
    const int push = addAccessor(
        gltf, bytes, bytesOf(2.f, 0.f, 0.f, 2.f, 0.f, 0.f, 2.f, 0.f, 0.f, 2.f, 0.f, 0.f), "VEC3",
        kFloat, 4);
    gltf["meshes"][0]["primitives"][0]["targets"] = {
        {{"POSITION", lift}}, {{"NORMAL", 0}}, {{"POSITION", push}}};
  }
  Vector3d firstCorner() const { return meshOfGltf(gltf, bytes).vertices.col(0); }
};

TEST(GltfMorph, AddsTargetsByTheirDefaultWeights) {
  MorphSquare morph;
  EXPECT_EQ(morph.firstCorner(), Vector3d(0, 0, 0));
  morph.gltf["meshes"][0]["weights"] = {0.5, 1, 0.25};
  EXPECT_EQ(morph.firstCorner(), Vector3d(0.5, 0, 0.5));
  morph.gltf["nodes"][0]["weights"] = {0, 0, 1};  // The node's own hold.
  EXPECT_EQ(morph.firstCorner(), Vector3d(2, 0, 0));
  morph.gltf["nodes"][0]["translation"] = {0, 7, 0};
  EXPECT_EQ(morph.firstCorner(), Vector3d(2, 7, 0));
}

TEST(GltfMorph, PrimitivesOfTheSameVerticesMayMorphDifferently) {
  MorphSquare morph;
  morph.gltf["meshes"][0]["weights"] = {1, 0, 0};
  json& primitives = morph.gltf["meshes"][0]["primitives"];
  primitives.push_back(primitives[0]);
  primitives[1].erase("targets");
  const TriangleMesh mesh = meshOfGltf(morph.gltf, morph.bytes);
  EXPECT_EQ(mesh.vertices.cols(), 8);
  EXPECT_EQ(mesh.vertices(2, 0), 1);
  EXPECT_EQ(mesh.vertices(2, 4), 0);
}

TEST(GltfMorph, RefusesTargetsOfAnotherSize) {
  MorphSquare morph;
  morph.gltf["meshes"][0]["weights"] = {1};
  morph.gltf["accessors"][2]["count"] = 3;
  EXPECT_EQ(problemOfGltf(morph.gltf, morph.bytes),
            "a.glb: accessor 2: a morph target of 3 vertices, the primitive has 4");
}

/// The square, in centimetres, whose left corners follow joint 1 and whose right ones joint 2, of
/// an armature that scales by 0.01.
struct SkinnedSquare {
  json gltf = square();
  std::string bytes = squareBytes();

  SkinnedSquare() {
    using B = std::uint8_t;
    const int joints =
        addAccessor(gltf, bytes,
                    bytesOf<B, B, B, B>(0, 1, 0, 0) + bytesOf<B, B, B, B>(0, 1, 0, 0) +
                        bytesOf<B, B, B, B>(0, 1, 0, 0) + bytesOf<B, B, B, B>(0, 1, 0, 0),
                    "VEC4", kUnsignedByte, 4);
    const int weights =
        addAccessor(gltf, bytes,
                    bytesOf<B, B, B, B>(255, 0, 0, 0) + bytesOf<B, B, B, B>(0, 255, 0, 0) +
                        bytesOf<B, B, B, B>(0, 0, 0, 0) + bytesOf<B, B, B, B>(51, 51, 0, 0),
                    "VEC4", kUnsignedByte, 4);
    gltf["accessors"][weights]["normalized"] = true;
    json& attributes = gltf["meshes"][0]["primitives"][0]["attributes"];
    attributes["JOINTS_0"] = joints;
    attributes["WEIGHTS_0"] = weights;
    gltf["skins"] = json::parse(R"([{"joints": [2, 3]}])");
    gltf["nodes"] = json::parse(R"([{"scale": [0.01, 0.01, 0.01], "children": [1, 2, 3]},
      {"mesh": 0, "skin": 0, "translation": [99, 99, 99]}, {}, {"translation": [0, 0, 100]}])");
  }
};

/// Corner 2 has no weight and follows the first joint; corner 3 has 0.2 + 0.2, which count as
/// halves.
TEST(GltfSkin, JointsPlaceTheMeshAndItsNodeDoesNot) {
  const SkinnedSquare skinned;
  const TriangleMesh mesh = meshOfGltf(skinned.gltf, skinned.bytes);
  EXPECT_LT((mesh.vertices.col(0) - Vector3d(0, 0, 0)).norm(), 1e-12);
  EXPECT_LT((mesh.vertices.col(1) - Vector3d(0.01, 0, 1)).norm(), 1e-12);
  EXPECT_LT((mesh.vertices.col(2) - Vector3d(0, 0.01, 0)).norm(), 1e-12);
  EXPECT_LT((mesh.vertices.col(3) - Vector3d(0.01, 0.01, 0.5)).norm(), 1e-12);
}

TEST(GltfSkin, InverseBindMatricesTakeTheMeshToItsJoints) {
  SkinnedSquare skinned;
  const std::string shift =
      bytesOf(1.f, 0.f, 0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 300.f, 0.f, 1.f);
  skinned.gltf["skins"][0]["inverseBindMatrices"] =
      addAccessor(skinned.gltf, skinned.bytes, shift + shift, "MAT4", kFloat, 2);
  const TriangleMesh mesh = meshOfGltf(skinned.gltf, skinned.bytes);
  EXPECT_LT((mesh.vertices.col(1) - Vector3d(0.01, 3, 1)).norm(), 1e-12);
  skinned.gltf["accessors"][4]["count"] = 1;
  EXPECT_EQ(problemOfGltf(skinned.gltf, skinned.bytes),
            "a.glb: skin 0: 2 joints, 1 inverse bind matrices");
}

TEST(GltfSkin, JointsMayLieOutsideOfTheScene) {
  SkinnedSquare skinned;
  skinned.gltf["nodes"][0]["children"] = {2, 3};
  skinned.gltf["scenes"][0]["nodes"] = {1};
  EXPECT_LT((meshOfGltf(skinned.gltf, skinned.bytes).vertices.col(1) - Vector3d(0.01, 0, 1)).norm(),
            1e-12);
}

/// Without joints of their own, vertices stay with their node.
TEST(GltfSkin, PrimitivesWithoutJointsFollowTheirNode) {
  SkinnedSquare skinned;
  skinned.gltf["meshes"][0]["primitives"][0]["attributes"].erase("JOINTS_0");
  EXPECT_LT(
      (meshOfGltf(skinned.gltf, skinned.bytes).vertices.col(1) - Vector3d(1, 0.99, 0.99)).norm(),
      1e-12);
}

TEST(GltfSkin, RefusesWhatIsOutOfRange) {
  SkinnedSquare skinned;
  skinned.gltf["skins"][0]["joints"] = {2};
  EXPECT_EQ(problemOfGltf(skinned.gltf, skinned.bytes),
            "a.glb: joint 1 does not exist, there are 1 (counted from 0)");
  skinned.gltf["skins"][0]["joints"] = {2, 7};
  EXPECT_EQ(problemOfGltf(skinned.gltf, skinned.bytes),
            "a.glb: node 7 does not exist, there are 4 (counted from 0)");
  skinned.gltf["nodes"][1]["skin"] = 1;
  EXPECT_EQ(problemOfGltf(skinned.gltf, skinned.bytes),
            "a.glb: skin 1 does not exist, there are 1 (counted from 0)");
  skinned = {};
  skinned.gltf["accessors"][3]["count"] = 3;
  EXPECT_THAT(problemOfGltf(skinned.gltf, skinned.bytes),
              HasSubstr("joints and weights must be as many as the 4 vertices, got 4 and 3"));
}

TEST(GltfVisibility, LeavesHiddenNodesOut) {
  json gltf = square();
  gltf["nodes"] = json::parse(R"([{"mesh": 0}, {"mesh": 0, "translation": [-5, 0, 0]}])");
  gltf["scenes"][0]["nodes"] = {0, 1};
  EXPECT_EQ(meshOfGltf(gltf).triangles.cols(), 4);
  json& visibility = gltf["nodes"][1]["extensions"]["KHR_node_visibility"];
  visibility["visible"] = true;
  EXPECT_EQ(meshOfGltf(gltf).triangles.cols(), 4);
  visibility["visible"] = false;
  const TriangleMesh mesh = meshOfGltf(gltf);
  EXPECT_EQ(mesh.triangles.cols(), 2);
  EXPECT_EQ(boundingBox(mesh).min().x(), 0);
}

TEST(GltfVisibility, IsThatOfTheNodesAbove) {
  json gltf = square();
  gltf["nodes"] = json::parse(R"([{"children": [1]}, {"mesh": 0}])");
  gltf["nodes"][0]["extensions"]["KHR_node_visibility"]["visible"] = false;
  EXPECT_EQ(problemOfGltf(gltf), "a.glb: holds no triangle");
  gltf["nodes"][0]["extensions"]["KHR_node_visibility"] = {1, 2};
  EXPECT_EQ(meshOfGltf(gltf).triangles.cols(), 2);
}

}  // namespace
}  // namespace morphgrid
