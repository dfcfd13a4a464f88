#include "benchmark/congruence.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iostream>

#include "app/simulate_scene.h"
#include "benchmark/fidelity_cases.h"
#include "core/interrupt.h"

namespace morphgrid {
namespace {

using Points = BezierPatch::ControlPoints;

constexpr int kCoarseNodes = 12;
// Designs for the true shape go on until the distance hardly falls: on the way there images differ.
constexpr int kStepsToTheEnd = 60;
// A fifth of so long a strut would be more than thin layers are apart.
constexpr double kBarHeight = 0.7;  // Of the layer spacing.
constexpr double kLarger = 1000;
// RMS in percent below which nobody asks which of two is closer: that is where rounds of correction
// end, too.
constexpr double kClose = 0.01;

Points& pointsOf(Scene& scene) { return std::get<PatchRequest>(scene.surface).controlPoints; }

template <typename Map>
Scene mapped(Scene scene, const Map& map) {
  for (auto& row : pointsOf(scene)) {
    for (Eigen::Vector3d& point : row) point = map(point);
  }
  return scene;
}

Scene asItIs(Scene scene) { return scene; }

Scene mirroredInX(Scene scene) {
  return mapped(std::move(scene),
                [](const Eigen::Vector3d& p) { return Eigen::Vector3d(-p.x(), p.y(), p.z()); });
}

Scene mirroredInZ(Scene scene) {
  return mapped(std::move(scene),
                [](const Eigen::Vector3d& p) { return Eigen::Vector3d(p.x(), p.y(), -p.z()); });
}

Scene uReversed(Scene scene) {
  for (auto& row : pointsOf(scene)) std::reverse(row.begin(), row.end());
  return scene;
}

Scene vReversed(Scene scene) {
  std::reverse(pointsOf(scene).begin(), pointsOf(scene).end());
  return scene;
}

Scene swapped(Scene scene) {
  const Points points = pointsOf(scene);
  for (std::size_t j = 0; j < points.size(); ++j) {
    for (std::size_t i = 0; i < points[j].size(); ++i) pointsOf(scene)[i][j] = points[j][i];
  }
  return scene;
}

Scene enlarged(Scene scene) {
  scene.design.layerSpacing *= kLarger;
  MaterialRequest& material = scene.material;
  for (std::optional<double>* length :
       {&scene.design.strutThickness, &material.barWidth, &material.barHeight, &material.postWidth,
        &material.jointRadius}) {
    if (*length) **length *= kLarger;
  }
  return mapped(std::move(scene),
                [](const Eigen::Vector3d& p) { return Eigen::Vector3d(kLarger * p); });
}

Scene moved(Scene scene) {
  const double step = 10 * scene.design.layerSpacing;
  return mapped(std::move(scene), [step](const Eigen::Vector3d& p) {
    return Eigen::Vector3d(p + step * Eigen::Vector3d(3, -2, 1));
  });
}

Scene turned(Scene scene) {
  const Eigen::Matrix3d rotation =
      Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  return mapped(std::move(scene),
                [&](const Eigen::Vector3d& p) { return Eigen::Vector3d(rotation * p); });
}

CongruenceResult::End endOf(const std::shared_ptr<Device>& device, const CongruentImage& image,
                            const Scene& scene) {
  const SceneDesign designed = designScene(scene);
  RunContext context{.device = device};
  CheckpointKeeper keeper({}, {});
  const RunRecord record = simulateScene(scene, designed, context, keeper, true).record;
  const Equilibrium& equilibrium = record.full.value();
  const double diagonal = record.distance.value().diagonal;
  return {image.name, equilibrium.converged && !context.failure, record.distance->rmsPercent,
          equilibrium.energy / (diagonal * diagonal), record.inverse ? record.inverse->ending : ""};
}

constexpr const char* kCongruenceHead =
    "| surface, design | images | converged | RMS as it is | least | most | most over least, less "
    "1 "
    "| endings of inverse designs |\n"
    "| --- | --- | --- | --- | --- | --- | --- | --- |\n";

std::string endingsOf(const CongruenceResult& result) {
  std::vector<std::string> endings;
  for (const auto& end : result.ends) {
    const auto found = std::ranges::find(endings, end.inverseEnding);
    if (!end.inverseEnding.empty() && found == endings.end()) endings.push_back(end.inverseEnding);
  }
  return fmt::format("{}", fmt::join(endings, "; "));
}

std::string toRow(const CongruenceResult& result) {
  const auto [least, most] =
      std::ranges::minmax(result.ends, {}, &CongruenceResult::End::rmsPercent);
  return fmt::format("| {} | {} | {} | {:.4f} | {:.4f} ({}) | {:.4f} ({}) | {:.1f} % | {} |\n",
                     result.name, result.ends.size(),
                     std::ranges::count_if(result.ends, &CongruenceResult::End::converged),
                     result.ends.front().rmsPercent, least.rmsPercent, least.image, most.rmsPercent,
                     most.image, 100 * result.spread(), endingsOf(result));
}

}  // namespace

const std::vector<CongruentImage>& congruentImages() {
  static const std::vector<CongruentImage> images{{"as it is", asItIs},
                                                  {"x mirrored", mirroredInX},
                                                  {"z mirrored", mirroredInZ},
                                                  {"u reversed", uReversed},
                                                  {"v reversed", vReversed},
                                                  {"u and v swapped", swapped},
                                                  {"1000 times as large", enlarged},
                                                  {"moved", moved},
                                                  {"turned", turned}};
  return images;
}

double CongruenceResult::spread() const {
  const auto [least, most] = std::ranges::minmax(ends, {}, &End::rmsPercent);
  return most.rmsPercent <= kClose ? 0 : most.rmsPercent / least.rmsPercent - 1;
}

CongruenceResult congruenceOf(const std::shared_ptr<Device>& device, const std::string& name,
                              const Scene& scene, const std::vector<CongruentImage>& images) {
  CongruenceResult result{name, {}};
  for (const CongruentImage& image : images) {
    result.ends.push_back(endOf(device, image, image.of(scene)));
  }
  return result;
}

std::vector<CongruenceResult> measureCongruence(const std::shared_ptr<Device>& device,
                                                const std::filesystem::path& scenes,
                                                const std::string& only) {
  std::vector<CongruenceResult> results;
  const auto measure = [&](const std::string& name, const std::function<Scene()>& load) {
    if (("congruence: " + name).find(only) == std::string::npos || interruptRequested()) return;
    if (results.empty()) fmt::print("\n{}", kCongruenceHead);
    Scene scene = load();
    scene.design.nodesLong = kCoarseNodes;
    results.push_back(congruenceOf(device, name, scene));
    fmt::print("{}", toRow(results.back()));
    std::cout.flush();
  };
  const std::vector<FidelityCase> cases = listFidelityCases(scenes);
  for (const char* name : {"patch", "egg_chair", "iris_petal", "random_1", "random_2"}) {
    const auto found = std::ranges::find(cases, name, &FidelityCase::name);
    measure(fmt::format("{}, paper's", name), found->papers);
    measure(fmt::format("{}, true shape", name), [&] {
      Scene scene = found->ours();
      scene.design.optimiseSteps = kStepsToTheEnd;
      scene.material.barHeight = kBarHeight * scene.design.layerSpacing;
      return scene;
    });
  }
  return results;
}

std::string toMarkdown(const std::vector<CongruenceResult>& results) {
  std::string text = fmt::format(
      "Five surfaces, each with the paper's design and with the one for the true shape (a frame, "
      "inverse design of {} steps, bars {} of the layer spacing high), {} nodes along\n"
      "the longer side: as they are, mirrored, reversed, swapped, 1000 times as large, moved, "
      "turned. RMS: distance of the morphed\n"
      "middle layer to its target, percent of the diagonal; the paper's designs are judged by "
      "their "
      "springs, those for the true shape as\n"
      "frames: compare images, not designs. Where none is beyond {} % they count as one.\n\n",
      kStepsToTheEnd, kBarHeight, kCoarseNodes, kClose);
  text += kCongruenceHead;
  for (const CongruenceResult& result : results) text += toRow(result);
  return text;
}

}  // namespace morphgrid
