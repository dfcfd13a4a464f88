#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <limits>

#include "surface/load_mesh.h"
#include "tests/support/temporary_folder.h"
#include "tests/surface/gltf_squares.h"
#include "tests/surface/mesh_files.h"

namespace morphgrid {
namespace {

using nlohmann::json;
using testing::HasSubstr;

const char* const kDataUri =
    "data:application/octet-stream;base64,"
    "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAACAPwAAgD8AAAAAAAABAAIAAgABAAMA";

TEST(ReadGltf, ReadsGlb) {
  const TriangleMesh mesh = meshOfGltf(square());
  Eigen::Matrix3Xi triangles(3, 2);
  triangles << 0, 2, 1, 1, 2, 3;
  EXPECT_EQ(mesh.triangles, triangles);
  EXPECT_EQ(mesh.vertices.col(3), Eigen::Vector3d(1, 1, 0));
}

TEST(ReadGltf, ReadsDataUris) {
  json gltf = square();
  gltf["buffers"][0]["uri"] = kDataUri;
  EXPECT_NEAR(areaOf(meshOf("a.gltf", gltf.dump())), 1, 1e-12);
  gltf["buffers"][0]["uri"] = "data:application/octet-stream;base64,AAAA";
  EXPECT_EQ(problemOf("a.gltf", gltf.dump()),
            "a.gltf: buffer 0: says that it has 60 bytes, there are 3");
}

TEST(ReadGltf, ReadsBuffersBesideTheFile) {
  const TemporaryFolder folder;
  json gltf = square();
  gltf["buffers"][0]["uri"] = "data/a%20b.bin";
  const auto file = folder.write("a.gltf", gltf.dump());
  EXPECT_THAT(problemOfFile(file), HasSubstr("a b.bin: cannot be read: No such file or directory"));
  folder.write("data/a b.bin", squareBytes());
  EXPECT_NEAR(areaOf(loadMesh(file).mesh), 1, 1e-12);
  json twice = gltf;
  twice["buffers"].push_back({{"byteLength", 60}, {"uri", "data/../data/a b.bin"}});
  twice["bufferViews"][1]["buffer"] = 1;
  EXPECT_NEAR(areaOf(loadMesh(folder.write("twice.gltf", twice.dump())).mesh), 1, 1e-12);
  folder.write("data/a b.bin", squareBytes() + "more");
  EXPECT_NEAR(areaOf(loadMesh(file).mesh), 1, 1e-12);
  folder.write("data/a b.bin", "short");
  EXPECT_THAT(problemOfFile(file),
              HasSubstr("a.gltf: buffer 0: says that it has 60 bytes, there are 5"));
}

TEST(ReadGltf, RefusesBuffersThatLieElsewhere) {
  const TemporaryFolder folder;
  const auto elsewhere = folder.write("buffer.bin", "short");
  folder.write("meshes/inside/buffer.bin", squareBytes());
  std::filesystem::create_symlink(elsewhere, elsewhere.parent_path() / "meshes/link.bin");
  json gltf = square();
  for (const std::string uri :
       {elsewhere.string(), std::string("../buffer.bin"), std::string("%2e%2e/buffer.bin"),
        std::string("inside/../../buffer.bin"), std::string("link.bin")}) {
    gltf["buffers"][0]["uri"] = uri;
    EXPECT_THAT(problemOfFile(folder.write("meshes/a.gltf", gltf.dump())),
                HasSubstr("a.gltf: buffer 0: its file must lie in the folder of the glTF file"))
        << uri;
  }
  gltf["buffers"][0]["uri"] = "../meshes/inside/buffer.bin";
  EXPECT_NEAR(areaOf(loadMesh(folder.write("meshes/a.gltf", gltf.dump())).mesh), 1, 1e-12);
}

TEST(ReadGltf, RefusesUrisThatNameNoFile) {
  json gltf = square();
  for (const std::string uri : {"http://a/b.bin", "blob:0", "data:;base64", "data:;base64,A*AA"}) {
    gltf["buffers"][0]["uri"] = uri;
    EXPECT_THAT(problemOf("a.gltf", gltf.dump()), HasSubstr('"' + uri + '"')) << uri;
  }
  gltf["buffers"][0]["uri"] = "data;" + std::string(100'000, 'A');
  EXPECT_EQ(problemOf("a.gltf", gltf.dump()),
            "a.gltf: buffer 0: its URI is no file's: \"data;" + std::string(27, 'A') + "...\"");
}

TEST(ReadGltf, ReadsListsStripsAndFansWithAndWithoutIndices) {
  json gltf = square();
  json& primitive = gltf["meshes"][0]["primitives"][0];
  primitive.erase("indices");
  primitive["mode"] = 5;
  Eigen::Matrix3Xi strip(3, 2);
  strip << 0, 1, 1, 3, 2, 2;  // The second triangle is turned, so that both face the same way.
  EXPECT_EQ(meshOfGltf(gltf).triangles, strip);
  primitive["mode"] = 6;
  Eigen::Matrix3Xi fan(3, 2);
  fan << 0, 0, 1, 2, 2, 3;
  EXPECT_EQ(meshOfGltf(gltf).triangles, fan);
  primitive["mode"] = 4;
  EXPECT_EQ(problemOfGltf(gltf),
            "a.glb: a primitive of triangles has 4 corners: not a multiple of 3");
  gltf["accessors"][0]["count"] = 3;
  EXPECT_EQ(meshOfGltf(gltf).triangles, Eigen::Vector3i(0, 1, 2));
}

TEST(ReadGltf, AppliesTheTransformsOfAllAncestors) {
  json gltf = square();
  gltf["nodes"] = json::parse(R"([
    {"translation": [10, 0, 0], "children": [1]},
    {"rotation": [0, 0, 0.7071067811865476, 0.7071067811865476], "children": [2]},
    {"mesh": 0, "scale": [2, 3, 1]}])");
  const TriangleMesh mesh = meshOfGltf(gltf);
  EXPECT_LT((mesh.vertices.col(1) - Eigen::Vector3d(10, 2, 0)).norm(), 1e-12);
  EXPECT_LT((mesh.vertices.col(2) - Eigen::Vector3d(7, 0, 0)).norm(), 1e-12);
  gltf["nodes"] = json::parse(R"([{"mesh": 0, "matrix": [0,2,0,0, -3,0,0,0, 0,0,1,0, 10,0,0,1]}])");
  EXPECT_LT((meshOfGltf(gltf).vertices - mesh.vertices).norm(), 1e-12);
}

TEST(ReadGltf, JoinsPrimitivesMeshesAndNodes) {
  json gltf = square();
  json& primitives = gltf["meshes"][0]["primitives"];
  primitives.push_back(primitives[0]);
  primitives.push_back({{"attributes", {{"POSITION", 0}}}, {"mode", 1}});  // Lines are none of it.
  gltf["meshes"].push_back(gltf["meshes"][0]);
  gltf["nodes"] =
      json::parse(R"([{"mesh": 0}, {"mesh": 1, "translation": [0, 0, 5]}, {"mesh": 1}])");
  gltf["scenes"][0]["nodes"] = {0, 1};
  const TriangleMesh mesh = meshOfGltf(gltf);
  EXPECT_EQ(mesh.triangles.cols(), 8);
  EXPECT_EQ(mesh.vertices.cols(), 8);  // A mesh's primitives share theirs.
  EXPECT_EQ(boundingBox(mesh).max().z(), 5);
  gltf.erase("scenes");
  gltf.erase("scene");
  EXPECT_EQ(meshOfGltf(gltf).triangles.cols(), 12);
}

TEST(ReadGltf, ReadsQuantizedAndInterleavedPositions) {
  json gltf = square();
  gltf["meshes"][0]["primitives"][0].erase("indices");
  gltf["bufferViews"] = json::parse(R"([{"buffer": 0, "byteLength": 24, "byteStride": 8}])");
  gltf["buffers"][0]["byteLength"] = 24;
  gltf["accessors"] = json::parse(R"([{"bufferView": 0, "count": 3, "type": "VEC3"}])");
  gltf["accessors"][0]["componentType"] = 5122;  // Short.
  using I = std::int16_t;
  const std::string bytes = bytesOf<I, I, I, I>(0, 0, 0, 7) + bytesOf<I, I, I, I>(32767, 0, 0, 7) +
                            bytesOf<I, I, I, I>(0, -32768, 0, 7);
  EXPECT_EQ(meshOfGltf(gltf, bytes).vertices.col(2), Eigen::Vector3d(0, -32768, 0));
  gltf["accessors"][0]["normalized"] = true;
  EXPECT_EQ(meshOfGltf(gltf, bytes).vertices.col(1), Eigen::Vector3d(1, 0, 0));
  EXPECT_EQ(meshOfGltf(gltf, bytes).vertices.col(2), Eigen::Vector3d(0, -1, 0));
}

TEST(ReadGltf, NeedsNoImages) {
  json gltf = square();
  gltf["images"] = json::parse(
      R"([{"uri": "none.png"}, {"uri": "data:image/webp;base64,AAAA"}, {"bufferView": 99}, 3])");
  gltf["materials"] = json::parse(R"([{"pbrMetallicRoughness": 7}])");
  gltf["animations"] = "broken";
  EXPECT_EQ(meshOfGltf(gltf).triangles.cols(), 2);
}

TEST(ReadGltf, RefusesWhatIsOutOfRange) {
  struct Case {
    const char* place;
    json value;
    const char* message;
  };
  const Case cases[] = {
      {"/scene", 1, "a.glb: scene 1 does not exist, there are 1 (counted from 0)"},
      {"/scenes/0/nodes/0", 7, "a.glb: node 7 does not exist, there are 1 (counted from 0)"},
      {"/nodes/0/mesh", 2, "a.glb: mesh 2 does not exist, there are 1 (counted from 0)"},
      {"/nodes/0/scale", {1, 2}, "a.glb: a node's transform needs 3 numbers, got 2"},
      {"/meshes/0/primitives/0/attributes/POSITION", 2,
       "a.glb: accessor 2 does not exist, there are 2 (counted from 0)"},
      {"/meshes/0/primitives/0/attributes/POSITION", 1,
       "a.glb: accessor 1: positions must be VEC3 of floats, bytes or shorts"},
      {"/meshes/0/primitives/0/indices", 0,
       "a.glb: accessor 0: indices must be SCALAR, unsigned bytes, shorts or ints"},
      {"/meshes/0/primitives/0/mode", 7, "a.glb: mesh 0: a mode must be 0 to 6, got 7"},
      {"/accessors/0/count", 5,
       "a.glb: accessor 0: 5 elements, its buffer view holds 4 from byte 0 on"},
      {"/accessors/0/count", 0x8000'0000'0000'0000u,
       "a.glb: accessor 0: 9223372036854775808 elements, its buffer view holds 4 from byte 0 on"},
      {"/accessors/0/byteOffset", 8,
       "a.glb: accessor 0: 4 elements, its buffer view holds 3 from byte 8 on"},
      {"/accessors/0/byteOffset", 0xffff'ffff'ffff'fff0u,
       "a.glb: accessor 0: 4 elements, its buffer view holds 0 from byte 18446744073709551600 on"},
      {"/accessors/0/bufferView", 5,
       "a.glb: buffer view 5 does not exist, there are 2 (counted from 0)"},
      {"/bufferViews/0/byteLength", 61,
       "a.glb: buffer view 0: 61 bytes from byte 0 on, the buffer has 60"},
      {"/bufferViews/0/byteOffset", 0xffff'ffff'ffff'fff0u,
       "a.glb: buffer view 0: 48 bytes from byte 18446744073709551600 on, the buffer has 60"},
      {"/bufferViews/0/buffer", 1, "a.glb: buffer 1 does not exist, there are 1 (counted from 0)"},
  };
  for (const Case& bad : cases) {
    json gltf = square();
    gltf[json::json_pointer(bad.place)] = bad.value;
    EXPECT_EQ(problemOfGltf(gltf), bad.message) << bad.place;
  }
}

TEST(ReadGltf, RefusesBadValues) {
  std::string bytes = squareBytes();
  bytes.replace(58, 2, bytesOf(std::uint16_t{4}));
  EXPECT_EQ(problemOfGltf(square(), bytes),
            "a.glb: accessor 1: element 5: vertex 4 does not exist, there are 0 to 3");
  bytes = squareBytes().replace(16, 4, bytesOf(std::numeric_limits<float>::quiet_NaN()));
  EXPECT_EQ(problemOfGltf(square(), bytes),
            "a.glb: accessor 0: element 1: numbers must be finite, got nan");
  json gltf = square();
  gltf["nodes"][0]["scale"] = {1e308, 1e308, 1e308};
  gltf["nodes"][0]["translation"] = {1.7e308, 0, 0};
  EXPECT_EQ(problemOfGltf(gltf), "a.glb: vertex 1: coordinates must be finite, got inf, 0, 0");
}

TEST(ReadGltf, RefusesNodesInACircle) {
  json gltf = square();
  gltf["nodes"] = json::parse(R"([{"children": [1]}, {"children": [0]}])");
  EXPECT_EQ(problemOfGltf(gltf), "a.glb: node 0 has two parents");
}

TEST(ReadGltf, RefusesToRepeatMeshesWithoutEnd) {
  json gltf = square();
  for (int i = 0; i < 20; ++i) {  // Each repeats the square once more.
    gltf["nodes"].push_back({{"mesh", 0}});
    gltf["scenes"][0]["nodes"].push_back(i + 1);
  }
  EXPECT_EQ(meshOfGltf(gltf).triangles.cols(), 42);
  json& primitives = gltf["meshes"][0]["primitives"];
  for (int i = 0; i < 600; ++i) primitives.push_back(primitives[0]);
  EXPECT_EQ(meshOfGltf(gltf).triangles.cols(), 42 * 601);
  for (int i = 0; i < 3000; ++i) {
    gltf["nodes"].push_back({{"mesh", 0}});
    gltf["scenes"][0]["nodes"].push_back(i + 21);
  }
  EXPECT_EQ(problemOfGltf(gltf),
            "a.glb: has more values read, or its meshes repeated more often, than can be held in "
            "memory");
}

TEST(ReadGltf, OneBufferAloneIsTheBinaryChunk) {
  json gltf = square();
  gltf["buffers"].push_back(gltf["buffers"][0]);
  EXPECT_EQ(problemOfGltf(gltf),
            "a.glb: buffer 1: has no URI, and is no binary chunk of a GLB file");
}

TEST(ReadGltf, RefusesBrokenJson) {
  EXPECT_EQ(problemOf("a.gltf", "[]"), "a.gltf: the JSON must be an object");
  EXPECT_THAT(problemOf("a.gltf", "{\"asset\": }"),
              HasSubstr("a.gltf: parse error at line 1, column 11"));
  EXPECT_THAT(problemOf("a.gltf", "{}"), HasSubstr("asset"));
  EXPECT_EQ(problemOf("a.gltf", R"({"asset": {"version": "2.0"}})"), "a.gltf: holds no triangle");
}

TEST(ReadGltf, NamesWhatCannotBeRead) {
  EXPECT_EQ(problemOf("a.gltf", R"({"asset": {"version": "1.0"}, "meshes": {"m": {}}})"),
            "a.gltf: is glTF 1.0, which cannot be read: only version 2 can");
  EXPECT_EQ(problemOf("a.gltf", R"({"asset": {"generator": "a"}})"),
            "a.gltf: is no glTF: asset.version must be a string, e.g. \"2.0\"");
  EXPECT_EQ(problemOf("a.gltf", std::string("{\0\"\0a\0", 6)),
            "a.gltf: is UTF-16 text, which cannot be read: save it as UTF-8");
  json points = square();
  points["meshes"][0]["primitives"][0]["mode"] = 0;
  EXPECT_EQ(problemOfGltf(points),
            "a.glb: holds 4 points but no faces: a point cloud must be meshed first");
}

TEST(ReadGltf, RefusesRequiredExtensionsThatMayMoveTriangles) {
  json gltf = square();
  gltf["extensionsRequired"] = {"KHR_mesh_quantization", "KHR_materials_unlit",
                                "KHR_texture_transform", "KHR_node_visibility"};
  EXPECT_EQ(problemOfGltf(gltf), "");
  for (const std::string name : {"EXT_mesh_gpu_instancing", "ACME_unknown", "KHR_texture"}) {
    gltf["extensionsRequired"] = {"KHR_materials_unlit", name};
    EXPECT_EQ(problemOfGltf(gltf), "a.glb: needs the extension " + name + ", which cannot be read");
  }
  for (const std::string name :
       {"KHR_draco_mesh_compression", "EXT_meshopt_compression", "KHR_meshopt_compression"}) {
    gltf["extensionsRequired"] = {name};
    EXPECT_EQ(problemOfGltf(gltf), "a.glb: needs the extension " + name +
                                       ", which cannot be read: export it without compression");
  }
}

TEST(ReadGltf, PassesOverDeepNesting) {
  const std::string deep = std::string(100'000, '[') + std::string(100'000, ']');
  for (const char* const place : {"/extras", "/nodes/0/extras", "/nodes/0/extensions"}) {
    json gltf = square();
    gltf[json::json_pointer(place)] = "HERE";
    gltf["buffers"][0]["uri"] = kDataUri;
    std::string text = gltf.dump();
    text.replace(text.find("\"HERE\""), 6, deep);
    EXPECT_EQ(meshOf("a.gltf", text).triangles.cols(), 2) << place;
  }
  EXPECT_THAT(problemOf("a.gltf", "{\"asset\": " + deep + "}"), HasSubstr("a.gltf: "));
}

TEST(ReadGltf, EveryTruncationOfAGlbIsAnError) {
  const std::string file = glb(square());
  for (std::size_t size = 0; size < file.size(); ++size) {
    const std::string problem = problemOf("a.glb", file.substr(0, size));
    EXPECT_THAT(problem, HasSubstr("a.glb: ")) << size;
    if (size < 12) continue;
    std::string shortened = file.substr(0, size);  // With a length that is right again.
    shortened.replace(8, 4, bytesOf(static_cast<std::uint32_t>(size)));
    EXPECT_THAT(problemOf("a.glb", shortened), HasSubstr("a.glb: ")) << size;
  }
}

TEST(ReadGltf, NamesTheByteWhereAGlbBreaks) {
  std::string file = glb(square());
  EXPECT_EQ(problemOf("a.glb", std::string(file).replace(4, 4, bytesOf(1))),
            "a.glb: byte 4: is GLB of version 1, which cannot be read: only version 2 can");
  EXPECT_EQ(problemOf("a.glb", std::string(file).replace(12, 4, bytesOf(0x7fffffff))),
            "a.glb: byte 12: a chunk of 2147483647 bytes, the file has " +
                std::to_string(file.size() - 20) + " more");
  EXPECT_EQ(problemOf("a.glb", std::string(file).replace(16, 4, "NOSJ")),
            "a.glb: byte 16: a chunk of type \"JSON\" expected");
}

}  // namespace
}  // namespace morphgrid
