#include "export/gltf_morph.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/error.h"
#include "export/bar_mesh.h"
#include "tests/export/export_samples.h"
#include "tests/export/gltf_files.h"
#include "tests/support/strut_list.h"

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

TEST_F(GltfMorph, KeysAreTheMeshPlusATarget) {
  const tinygltf::Model model = roundTrip();
  const tinygltf::Primitive& lines = onlyPrimitive(model, "struts");
  const tinygltf::Primitive& surface = onlyPrimitive(model, "surface");
  ASSERT_EQ(lines.targets.size(), 3);
  ASSERT_EQ(surface.targets.size(), 3);
  const std::vector<Strut> struts = listStruts(kShape);
  const Eigen::MatrixXf ends = values<float>(model, lines.attributes.at("POSITION"), 3);
  const Eigen::MatrixXf vertices = values<float>(model, surface.attributes.at("POSITION"), 3);
  const Eigen::MatrixXf normals = values<float>(model, surface.attributes.at("NORMAL"), 3);
  EXPECT_EQ(ends.col(1), keys_[0].positions.col(struts[0].to).cast<float>());
  EXPECT_EQ(vertices, keys_[0].surface.vertices.cast<float>());
  for (std::size_t n = 0; n < 3; ++n) {
    const int endsTarget = lines.targets[n].at("POSITION");
    const Eigen::MatrixXf moved = ends + values<float>(model, endsTarget, 3);
    ASSERT_EQ(moved.cols(), 2 * struts.size());
    for (std::size_t i = 0; i < struts.size(); ++i) {
      EXPECT_EQ(moved.col(2 * i), keys_[n + 1].positions.col(struts[i].from).cast<float>());
      EXPECT_EQ(moved.col(2 * i + 1), keys_[n + 1].positions.col(struts[i].to).cast<float>());
    }
    const int verticesTarget = surface.targets[n].at("POSITION");
    const Eigen::MatrixXf bent = vertices + values<float>(model, verticesTarget, 3);
    EXPECT_LT((bent - keys_[n + 1].surface.vertices.cast<float>()).norm(), 1e-5 * bent.norm());
    const Eigen::MatrixXf turned =
        normals + values<float>(model, surface.targets[n].at("NORMAL"), 3);
    EXPECT_LT((turned - keys_[n + 1].surface.normals.cast<float>()).norm(), 1e-5);
    expectBounds(model, endsTarget);
    expectBounds(model, verticesTarget);
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
  const Eigen::MatrixXf begin = values<float>(model, bars.attributes.at("POSITION"), 3);
  const Eigen::MatrixXf end = begin + values<float>(model, bars.targets[0].at("POSITION"), 3);
  EXPECT_EQ(begin, barVertices(frame.grid, frame.grid.positions, unturned).cast<float>());
  const Eigen::MatrixXf wanted =
      barVertices(frame.grid, frame.positions, frame.rotations).cast<float>();
  EXPECT_LT((end - wanted).norm(), 1e-5 * wanted.norm());
}

TEST_F(GltfMorph, NumbersThatAreNoFloatsAreRefused) {
  keys_[2].positions(1, 3) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(exportGltfMorph(folder_ / "morph.glb", sample_.grid, keys_, timeline_), InputError);
  EXPECT_EQ(folder_.fileCount(), 0);
}

}  // namespace
}  // namespace morphgrid
