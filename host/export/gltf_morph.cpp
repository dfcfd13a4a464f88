#include "export/gltf_morph.h"

#include <cassert>

#include "export/gltf_parts.h"
#include "export/gltf_struts.h"

namespace morphgrid {
namespace {

/// What a morph target adds to the mesh.
int addDifference(tinygltf::Model& model, const Eigen::Matrix3Xd& to,
                  const Eigen::Matrix3Xd& from) {
  return addPositions(model, (to - from).cast<float>());
}

void addMorphingStruts(tinygltf::Model& model, const StrutGrid& grid,
                       const std::vector<MorphKey>& keys, const Eigen::Vector3d& origin) {
  const auto vertices = [&](const MorphKey& key) {
    return strutVertices(grid, key.positions.colwise() - origin, key.rotations);
  };
  const MorphKey& begin = keys.front();
  const Eigen::Matrix3Xd first = vertices(begin);
  tinygltf::Primitive struts =
      addStruts(model, grid, begin.positions.colwise() - origin, begin.rotations);
  for (auto key = keys.begin() + 1; key != keys.end(); ++key) {
    struts.targets.push_back({{"POSITION", addDifference(model, vertices(*key), first)}});
  }
  addStrutNode(model, std::move(struts));
}

void addMorphingSurface(tinygltf::Model& model, const std::vector<MorphKey>& keys,
                        const Eigen::Vector3d& origin) {
  const SurfaceMesh& first = keys.front().surface;
  tinygltf::Primitive triangles;
  triangles.attributes["POSITION"] =
      addPositions(model, (first.vertices.colwise() - origin).cast<float>());
  triangles.attributes["NORMAL"] = addVectors(model, first.normals.cast<float>());
  triangles.indices = addIndices(model, first.triangles);
  for (auto key = keys.begin() + 1; key != keys.end(); ++key) {
    triangles.targets.push_back(
        {{"POSITION", addDifference(model, key->surface.vertices, first.vertices)},
         {"NORMAL", addDifference(model, key->surface.normals, first.normals)}});
  }
  addSurfaceNode(model, std::move(triangles));
}

/// The weights of all targets, moment after moment: 1 for the target of the moment's key, of which
/// the first has none.
Eigen::VectorXf targetWeights(const std::vector<MorphMoment>& timeline, std::size_t targetCount) {
  const auto count = static_cast<Eigen::Index>(targetCount);
  Eigen::MatrixXf weights =
      Eigen::MatrixXf::Zero(count, static_cast<Eigen::Index>(timeline.size()));
  for (Eigen::Index n = 0; n < weights.cols(); ++n) {
    const int key = timeline[static_cast<std::size_t>(n)].key;
    if (key > 0) {
      weights(key - 1, n) = 1;
    }
  }
  return weights.reshaped();
}

void addAnimation(tinygltf::Model& model, const std::vector<MorphMoment>& timeline,
                  std::size_t targetCount) {
  Eigen::VectorXf seconds(static_cast<Eigen::Index>(timeline.size()));
  for (std::size_t n = 0; n < timeline.size(); ++n) {
    seconds[static_cast<Eigen::Index>(n)] = static_cast<float>(timeline[n].seconds);
  }
  tinygltf::AnimationSampler sampler;
  sampler.input = addTimes(model, seconds);
  sampler.output = addScalars(model, targetWeights(timeline, targetCount));
  tinygltf::Animation animation;
  animation.name = "morph";
  animation.samplers = {sampler};
  for (std::size_t node = 0; node < model.nodes.size(); ++node) {
    model.meshes[static_cast<std::size_t>(model.nodes[node].mesh)].weights.assign(targetCount, 0);
    tinygltf::AnimationChannel channel;
    channel.sampler = 0;
    channel.target_node = static_cast<int>(node);
    channel.target_path = "weights";
    animation.channels.push_back(channel);
  }
  model.animations = {animation};
}

}  // namespace

void exportGltfMorph(const std::filesystem::path& path, const StrutGrid& grid,
                     const std::vector<MorphKey>& keys, const std::vector<MorphMoment>& timeline) {
  assert(keys.size() >= 2 && !timeline.empty());
  for (const MorphKey& key : keys) {
    requireFloats(path, key.positions);
    requireFloats(path, key.surface.vertices);
  }
  const Eigen::Vector3d origin = middleOf(keys.back().positions);
  tinygltf::Model model = emptyModel();
  addMorphingStruts(model, grid, keys, origin);
  addMorphingSurface(model, keys, origin);
  placeAt(model, origin);
  addAnimation(model, timeline, keys.size() - 1);
  writeModel(path, model);
}

}  // namespace morphgrid
