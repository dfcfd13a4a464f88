#include "export/gltf.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <cstring>
#include <limits>

#include "core/error.h"
#include "export/bar_mesh.h"
#include "export/gltf_struts.h"
#include "export/tube_mesh.h"
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

/// What the node of either mesh adds to its vertices, in the scene's axes.
Eigen::Vector3d originOf(const tinygltf::Model& model) {
  const std::vector<double>& moved = model.nodes.front().translation;
  EXPECT_EQ(model.nodes.back().translation, moved);
  return {moved.at(0), -moved.at(2), moved.at(1)};
}

/// glTF's vertex colours are light, of which displays show about the 2.2th root.
Eigen::Vector3f displayed(const Eigen::Vector3f& light) {
  return light.unaryExpr([](float value) {
    return value <= 0.0031308F ? 12.92F * value : 1.055F * std::pow(value, 1 / 2.4F) - 0.055F;
  });
}

void expectStrainColors(const tinygltf::Model& model, const ExportSample& sample, int perStrut) {
  const tinygltf::Primitive& struts = onlyPrimitive(model, "struts");
  const Eigen::MatrixXf colors = values<float>(model, struts.attributes.at("COLOR_0"), 3);
  const std::vector<double> strutStrains = strains(sample.grid, sample.positions);
  ASSERT_EQ(colors.cols(), perStrut * strutStrains.size());
  for (Eigen::Index n = 0; n < colors.cols(); ++n) {
    const vec3 color = strainColor(static_cast<float>(strutStrains[n / perStrut]));
    ASSERT_LT((displayed(colors.col(n)) - Eigen::Vector3f(color.r, color.g, color.b)).norm(), 1e-5)
        << n;
  }
}

TEST_P(Gltf, StrutsOfSpringsAreTubesInTheColorOfTheirStrain) {
  const ExportSample sample = exportSample(GetParam());
  const tinygltf::Model model = roundTrip(sample);
  const tinygltf::Primitive& tubes = onlyPrimitive(model, "struts");
  EXPECT_EQ(tubes.mode, TINYGLTF_MODE_TRIANGLES);
  EXPECT_TRUE(model.extensionsUsed.empty());
  const Eigen::MatrixXf vertices = values<float>(model, tubes.attributes.at("POSITION"), 3);
  const Eigen::Matrix3Xd wanted = tubeVertices(sample.grid, sample.positions);
  ASSERT_EQ(vertices.cols(), wanted.cols());
  EXPECT_LT(((vertices.cast<double>().colwise() + originOf(model)) - wanted).cwiseAbs().maxCoeff(),
            1e-6);
  EXPECT_EQ(values<int>(model, tubes.indices, 1),
            tubeTriangles(sample.grid.shape).reshaped().transpose());
  expectStrainColors(model, sample, kTubeMeshVertices);
  expectBounds(model, tubes.attributes.at("POSITION"));
}

TEST(LargeGltf, StrutsAreLines) {
  const ExportSample sample = exportSample({200, 130, 1});
  ASSERT_GT(sample.grid.shape.strutCount(), kMostSolidStruts);
  const tinygltf::Model model = roundTrip(sample);
  const tinygltf::Primitive& lines = onlyPrimitive(model, "struts");
  EXPECT_EQ(lines.mode, TINYGLTF_MODE_LINE);
  EXPECT_EQ(lines.indices, -1);
  EXPECT_EQ(model.extensionsUsed, std::vector<std::string>{"KHR_materials_unlit"});
  const Eigen::MatrixXf ends = values<float>(model, lines.attributes.at("POSITION"), 3);
  const std::vector<Strut> struts = listStruts(sample.grid.shape);
  ASSERT_EQ(ends.cols(), 2 * struts.size());
  const Eigen::Vector3d origin = originOf(model);
  for (std::size_t i = 0; i < struts.size(); ++i) {
    const Eigen::Vector3d from = sample.positions.col(struts[i].from) - origin;
    ASSERT_EQ(ends.col(2 * i), from.cast<float>());
    const Eigen::Vector3d to = sample.positions.col(struts[i].to) - origin;
    ASSERT_EQ(ends.col(2 * i + 1), to.cast<float>());
  }
  expectStrainColors(model, sample, 2);
}

TEST_P(Gltf, SurfaceKeepsItsNumbers) {
  const ExportSample sample = exportSample(GetParam());
  const tinygltf::Model model = roundTrip(sample);
  const tinygltf::Primitive& mesh = onlyPrimitive(model, "surface");
  EXPECT_EQ(mesh.mode, TINYGLTF_MODE_TRIANGLES);
  EXPECT_EQ(values<float>(model, mesh.attributes.at("POSITION"), 3),
            (sample.surface.vertices.colwise() - originOf(model)).cast<float>());
  EXPECT_EQ(values<float>(model, mesh.attributes.at("NORMAL"), 3),
            sample.surface.normals.cast<float>());
  EXPECT_EQ(values<int>(model, mesh.indices, 1), sample.surface.triangles.reshaped().transpose());
  EXPECT_TRUE(model.materials.at(mesh.material).doubleSided);
  expectBounds(model, mesh.attributes.at("POSITION"));
}

/// A part of 4 m in metres of a map's grid, where floats are 0.5 m apart.
TEST(GltfFile, FarFromTheOriginNothingCollapses) {
  ExportSample sample = exportSample({5, 4, 2});
  const Eigen::Vector3d away(447'000, 5'411'000, 312);
  sample.positions.colwise() += away;
  sample.grid.positions.colwise() += away;
  sample.surface.vertices.colwise() += away;
  const tinygltf::Model model = roundTrip(sample);
  const tinygltf::Primitive& surface = onlyPrimitive(model, "surface");
  const Eigen::MatrixXf vertices = values<float>(model, surface.attributes.at("POSITION"), 3);
  const Eigen::Matrix3Xd placed = vertices.cast<double>().colwise() + originOf(model);
  EXPECT_LT((placed - sample.surface.vertices).cwiseAbs().maxCoeff(), 1e-6);
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
  const Eigen::Matrix3Xd wanted = barVertices(sample.grid, sample.positions, sample.rotations);
  ASSERT_EQ(vertices.cols(), wanted.cols());
  EXPECT_LT(((vertices.cast<double>().colwise() + originOf(model)) - wanted).cwiseAbs().maxCoeff(),
            1e-6);
  EXPECT_EQ(values<int>(model, bars.indices, 1),
            barTriangles(sample.grid.shape).reshaped().transpose());
  expectStrainColors(model, sample, kBarMeshVertices);
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
