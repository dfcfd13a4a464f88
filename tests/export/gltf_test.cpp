#include "export/gltf.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cstring>
#include <limits>

#include "core/error.h"
#include "export/bar_mesh.h"
#include "grid/strain.h"
#include "shared/strain_color.h"
#include "tests/export/export_samples.h"
#include "tests/export/gltf_files.h"
#include "tests/support/strut_list.h"

namespace morphgrid {
namespace {

tinygltf::Model roundTrip(const ExportSample& sample) {
  const TemporaryFolder folder;
  exportGltf(folder / "morph.glb", sample.grid, sample.positions, sample.surface);
  EXPECT_EQ(folder.fileCount(), 1);
  return loadGltf(folder / "morph.glb");
}

class Gltf : public testing::TestWithParam<GridShape> {};
INSTANTIATE_TEST_SUITE_P(Shapes, Gltf, testing::ValuesIn(kSampleShapes), shapeName);

TEST_P(Gltf, StrutsKeepTheirEndsAndColors) {
  const ExportSample sample = exportSample(GetParam());
  const tinygltf::Model model = roundTrip(sample);
  const tinygltf::Primitive& lines = onlyPrimitive(model, "struts");
  EXPECT_EQ(lines.mode, TINYGLTF_MODE_LINE);
  EXPECT_EQ(lines.indices, -1);
  const Eigen::MatrixXf ends = values<float>(model, lines.attributes.at("POSITION"), 3);
  const Eigen::MatrixXf colors = values<float>(model, lines.attributes.at("COLOR_0"), 3);
  const std::vector<Strut> struts = listStruts(sample.grid.shape);
  const std::vector<double> strutStrains = strains(sample.grid, sample.positions);
  ASSERT_EQ(ends.cols(), 2 * struts.size());
  ASSERT_EQ(colors.cols(), ends.cols());
  for (std::size_t i = 0; i < struts.size(); ++i) {
    EXPECT_EQ(ends.col(2 * i), sample.positions.col(struts[i].from).cast<float>());
    EXPECT_EQ(ends.col(2 * i + 1), sample.positions.col(struts[i].to).cast<float>());
    const vec3 color = strainColor(static_cast<float>(strutStrains[i]));
    EXPECT_EQ(colors.col(2 * i), Eigen::Vector3f(color.r, color.g, color.b));
    EXPECT_EQ(colors.col(2 * i + 1), colors.col(2 * i));
  }
  expectBounds(model, lines.attributes.at("POSITION"));
}

TEST_P(Gltf, SurfaceKeepsItsNumbers) {
  const ExportSample sample = exportSample(GetParam());
  const tinygltf::Model model = roundTrip(sample);
  const tinygltf::Primitive& mesh = onlyPrimitive(model, "surface");
  EXPECT_EQ(mesh.mode, TINYGLTF_MODE_TRIANGLES);
  EXPECT_EQ(values<float>(model, mesh.attributes.at("POSITION"), 3),
            sample.surface.vertices.cast<float>());
  EXPECT_EQ(values<float>(model, mesh.attributes.at("NORMAL"), 3),
            sample.surface.normals.cast<float>());
  EXPECT_EQ(values<int>(model, mesh.indices, 1), sample.surface.triangles.reshaped().transpose());
  EXPECT_TRUE(model.materials.at(mesh.material).doubleSided);
  expectBounds(model, mesh.attributes.at("POSITION"));
}

TEST(GltfFile, SceneShowsBothNodesWithTheirZUp) {
  const tinygltf::Model model = roundTrip(exportSample({2, 2, 1}));
  EXPECT_EQ(model.asset.version, "2.0");
  ASSERT_EQ(model.scenes.size(), 1);
  EXPECT_EQ(model.defaultScene, 0);
  EXPECT_EQ(model.scenes[0].nodes, (std::vector<int>{0, 1}));
  for (const tinygltf::Node& node : model.nodes) {
    const Eigen::Quaterniond turn(node.rotation.at(3), node.rotation.at(0), node.rotation.at(1),
                                  node.rotation.at(2));
    EXPECT_LT((turn * Eigen::Vector3d::UnitZ() - Eigen::Vector3d::UnitY()).norm(), 1e-15);
    EXPECT_LT((turn * Eigen::Vector3d::UnitX() - Eigen::Vector3d::UnitX()).norm(), 1e-15);
  }
}

TEST(FrameGltf, StrutsAreTheirBarsInTheColorOfTheirStrain) {
  const TemporaryFolder folder;
  const FrameSample sample = frameSample({3, 4, 2});
  exportGltf(folder / "morph.glb", sample.grid, sample.positions, sample.surface, sample.rotations);
  const tinygltf::Model model = loadGltf(folder / "morph.glb");
  const tinygltf::Primitive& bars = onlyPrimitive(model, "struts");
  EXPECT_EQ(bars.mode, TINYGLTF_MODE_TRIANGLES);
  EXPECT_FALSE(model.materials.at(bars.material).extensions.contains("KHR_materials_unlit"));
  const Eigen::MatrixXf vertices = values<float>(model, bars.attributes.at("POSITION"), 3);
  EXPECT_EQ(vertices, barVertices(sample.grid, sample.positions, sample.rotations).cast<float>());
  EXPECT_EQ(values<int>(model, bars.indices, 1),
            barTriangles(sample.grid.shape).reshaped().transpose());
  const Eigen::MatrixXf colors = values<float>(model, bars.attributes.at("COLOR_0"), 3);
  ASSERT_EQ(colors.cols(), vertices.cols());
  const std::vector<double> strutStrains = strains(sample.grid, sample.positions);
  for (Eigen::Index n = 0; n < colors.cols(); ++n) {
    const vec3 color = strainColor(static_cast<float>(strutStrains[n / kBarMeshVertices]));
    ASSERT_EQ(colors.col(n), Eigen::Vector3f(color.r, color.g, color.b)) << n;
  }
  expectBounds(model, bars.attributes.at("POSITION"));
}

std::uint32_t wordAt(const std::string& bytes, std::size_t offset) {
  std::uint32_t word = 0;
  std::memcpy(&word, bytes.data() + offset, sizeof(word));
  return word;
}

// Read by hand: tinygltf's reader forgives what its writer gets wrong.
TEST(GltfFile, ContainerFollowsTheStandard) {
  const TemporaryFolder folder;
  const ExportSample sample = exportSample({5, 3, 2});
  exportGltf(folder / "morph.glb", sample.grid, sample.positions, sample.surface);
  const std::string bytes = readFile(folder / "morph.glb");
  ASSERT_GT(bytes.size(), 28);
  EXPECT_EQ(bytes.substr(0, 4), "glTF");
  EXPECT_EQ(wordAt(bytes, 4), 2);
  EXPECT_EQ(wordAt(bytes, 8), bytes.size());
  const std::uint32_t jsonLength = wordAt(bytes, 12);
  EXPECT_EQ(bytes.substr(16, 4), "JSON");
  EXPECT_EQ(jsonLength % 4, 0);
  EXPECT_EQ(bytes[20], '{');
  EXPECT_EQ(bytes.substr(20 + jsonLength + 4, 4), std::string("BIN\0", 4));
  EXPECT_EQ(20 + jsonLength + 8 + wordAt(bytes, 20 + jsonLength), bytes.size());
}

TEST(GltfFile, NumbersThatAreNoFloatsAreRefused) {
  const TemporaryFolder folder;
  for (const double bad : {1e39, std::numeric_limits<double>::quiet_NaN()}) {
    ExportSample sample = exportSample({2, 2, 1});
    sample.positions(1, 2) = bad;
    EXPECT_THROW(exportGltf(folder / "morph.glb", sample.grid, sample.positions, sample.surface),
                 InputError);
  }
  EXPECT_EQ(folder.fileCount(), 0);
}

}  // namespace
}  // namespace morphgrid
