#include "export/gltf_morph.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/error.h"
#include "export/bar_mesh.h"
#include "export/tube_mesh.h"
#include "tests/export/export_samples.h"
#include "tests/export/gltf_files.h"

namespace morphgrid {
namespace {

const GridShape kShape{5, 3, 2};

/// Shapes that differ in more than a rigid motion.
std::vector<MorphKey> sampleKeys(const ExportSample& sample, int count) {
  std::vector<MorphKey> keys;
  for (int n = 0; n < count; ++n) {
    Eigen::Matrix3Xd positions = sample.positions;
    positions.row(2).array() += n * positions.row(1).array().square();
    keys.push_back({positions, tessellate(kShape, middleLayer(kShape, positions), 2)});
  }
  return keys;
}

class GltfMorph : public testing::Test {
 protected:
  tinygltf::Model roundTrip() {
    exportGltfMorph(folder_ / "morph.glb", sample_.grid, keys_, timeline_);
    EXPECT_EQ(folder_.fileCount(), 1);
    return loadGltf(folder_ / "morph.glb");
  }

  TemporaryFolder folder_;
  ExportSample sample_ = exportSample(kShape);
  std::vector<MorphKey> keys_ = sampleKeys(sample_, 4);
  std::vector<MorphMoment> timeline_{{0, 0}, {0.5, 0}, {1, 1}, {1.5, 2}, {2, 3}, {4, 3}};
};

/// What the nodes add to the vertices, in the scene's axes.
Eigen::Vector3d originOfMorph(const tinygltf::Model& model) {
  const std::vector<double>& moved = model.nodes.front().translation;
  EXPECT_EQ(model.nodes.back().translation, moved);
  return {moved.at(0), -moved.at(2), moved.at(1)};
}

/// The primitive's vertices at a key, where its node places them.
Eigen::Matrix3Xd verticesAt(const tinygltf::Model& model, const tinygltf::Primitive& primitive,
                            std::size_t key) {
  Eigen::MatrixXf vertices = values<float>(model, primitive.attributes.at("POSITION"), 3);
  if (key > 0) {
    const int target = primitive.targets.at(key - 1).at("POSITION");
    vertices += values<float>(model, target, 3);
    expectBounds(model, target);
  }
  return vertices.cast<double>().colwise() + originOfMorph(model);
}

void expectNear(const Eigen::Matrix3Xd& found, const Eigen::Matrix3Xd& wanted) {
  ASSERT_EQ(found.cols(), wanted.cols());
  EXPECT_LT((found - wanted).cwiseAbs().maxCoeff(), 1e-5);
}

TEST_F(GltfMorph, KeysAreTheMeshPlusATarget) {
  const tinygltf::Model model = roundTrip();
  const tinygltf::Primitive& tubes = onlyPrimitive(model, "struts");
  const tinygltf::Primitive& surface = onlyPrimitive(model, "surface");
  ASSERT_EQ(tubes.targets.size(), 3);
  ASSERT_EQ(surface.targets.size(), 3);
  const Eigen::MatrixXf normals = values<float>(model, surface.attributes.at("NORMAL"), 3);
  for (std::size_t n = 0; n < keys_.size(); ++n) {
    expectNear(verticesAt(model, tubes, n), tubeVertices(sample_.grid, keys_[n].positions));
    expectNear(verticesAt(model, surface, n), keys_[n].surface.vertices);
  }
  for (std::size_t n = 0; n < 3; ++n) {
    const Eigen::MatrixXf turned =
        normals + values<float>(model, surface.targets[n].at("NORMAL"), 3);
    EXPECT_LT((turned - keys_[n + 1].surface.normals.cast<float>()).norm(), 1e-5);
  }
}

TEST_F(GltfMorph, AnimationRunsThroughTheKeys) {
  const tinygltf::Model model = roundTrip();
  ASSERT_EQ(model.animations.size(), 1);
  const tinygltf::Animation& animation = model.animations.front();
  EXPECT_EQ(animation.name, "morph");
  ASSERT_EQ(animation.channels.size(), 2);
  for (int node = 0; node < 2; ++node) {
    EXPECT_EQ(animation.channels[node].target_node, node);
    EXPECT_EQ(animation.channels[node].target_path, "weights");
    EXPECT_EQ(model.meshes.at(model.nodes.at(node).mesh).weights, std::vector<double>(3, 0));
    const tinygltf::AnimationSampler& sampler =
        animation.samplers.at(animation.channels[node].sampler);
    EXPECT_EQ(sampler.interpolation, "LINEAR");
    const Eigen::MatrixXf seconds = values<float>(model, sampler.input, 1);
    ASSERT_EQ(seconds.cols(), timeline_.size());
    expectBounds(model, sampler.input);
    const Eigen::VectorXf weights = values<float>(model, sampler.output, 1).transpose();
    ASSERT_EQ(weights.size(), 3 * timeline_.size());
    for (std::size_t n = 0; n < timeline_.size(); ++n) {
      EXPECT_EQ(seconds(0, n), timeline_[n].seconds);
      Eigen::Vector4f keyWeights = Eigen::Vector4f::Unit(timeline_[n].key);
      EXPECT_EQ(weights.segment<3>(3 * n), keyWeights.tail<3>()) << "moment " << n;
    }
  }
}

TEST_F(GltfMorph, OfAFrameMovesItsBars) {
  const FrameSample frame = frameSample(kShape);
  const JointRotations unturned = unturnedJoints(kShape.vertexCount());
  keys_ = {{frame.grid.positions, sample_.surface, unturned},
           {frame.positions, sample_.surface, frame.rotations}};
  timeline_ = {{0, 0}, {1, 1}};
  sample_.grid = frame.grid;
  const tinygltf::Model model = roundTrip();
  const tinygltf::Primitive& bars = onlyPrimitive(model, "struts");
  EXPECT_EQ(bars.mode, TINYGLTF_MODE_TRIANGLES);
  ASSERT_EQ(bars.targets.size(), 1);
  expectNear(verticesAt(model, bars, 0), barVertices(frame.grid, frame.grid.positions, unturned));
  expectNear(verticesAt(model, bars, 1), barVertices(frame.grid, frame.positions, frame.rotations));
}

TEST_F(GltfMorph, NumbersThatAreNoFloatsAreRefused) {
  keys_[2].positions(1, 3) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(exportGltfMorph(folder_ / "morph.glb", sample_.grid, keys_, timeline_), InputError);
  EXPECT_EQ(folder_.fileCount(), 0);
}

}  // namespace
}  // namespace morphgrid
