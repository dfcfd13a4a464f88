#include "app/mesh_sampler.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "core/error.h"
#include "surface/ray_hits.h"

namespace morphgrid {
namespace {

template <typename Work>
auto timed(double& seconds, Work work) {
  const auto start = std::chrono::steady_clock::now();
  auto result = work();
  seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

std::string inWords(const SamplingBox& box) {
  return fmt::format("u_start = {:.6g}, v_start = {:.6g}, u_length = {:.6g}, v_length = {:.6g}",
                     box.uStart, box.vStart, box.uLength, box.vLength);
}

std::string inWords(const Hole& hole) {
  return fmt::format("{} {} at u {:.4g} to {:.4g}, v {:.4g} to {:.4g}", hole.rays,
                     hole.rays == 1 ? "ray" : "rays", hole.uMin, hole.uMax, hole.vMin, hole.vMax);
}

}  // namespace

MeshSampler::MeshSampler(const MeshTarget& target)
    : target_(target),
      caster_(timed(figures_.secondsBuild, [&] { return MeshRayCaster(target.mesh); })) {
  figures_.file = target.file.string();
  figures_.triangles = static_cast<int>(target.mesh.triangles.cols());
  figures_.extent = boundingBox(target.mesh);
  figures_.suggestedBox =
      suggestBox(caster_, figures_.extent, target.samplesU, target.samplesV, target.steepestSlope);
}

RayHits MeshSampler::cast(int countU, int countV) {
  RayHits hits =
      timed(figures_.secondsRays, [&] { return caster_.cast(target_.box, countU, countV); });
  figures_.rays += static_cast<int>(hits.hit.size());
  figures_.missed += static_cast<int>(std::count(hits.hit.begin(), hits.hit.end(), 0));
  if (target_.fillHoles > 0) {
    fillHoles(hits, target_.fillHoles);
  }
  requireHits(hits);
  requireGentleSteps(hits);
  return hits;
}

void MeshSampler::requireHits(const RayHits& hits) const {
  const std::vector<Hole> holes = findHoles(hits);
  if (holes.empty()) {
    return;
  }
  int missed = 0;
  for (const Hole& hole : holes) {
    missed += hole.rays;
  }
  throw InputError(
      fmt::format("{} of {} rays miss {} in {} {}, the largest of {}; {}; or let "
                  "surface.fill_holes close holes "
                  "up to a width",
                  missed, hits.hit.size(), figures_.file, holes.size(),
                  holes.size() == 1 ? "hole" : "holes", inWords(holes.front()), boxAdvice()));
}

void MeshSampler::requireGentleSteps(const RayHits& hits) {
  const Jump jump = findJump(hits, target_.steepestSlope);
  figures_.largestJump = std::max(figures_.largestJump, jump.slope);
  if (jump.count == 0) {
    return;
  }
  throw InputError(fmt::format(
      "{} {} between neighbouring rays {} steeper than surface.steepest_slope = {:g}, the steepest "
      "({:.4g}) at u {:.4g}, v {:.4g}: an overhang seen from the side? Choose a box without it or "
      "raise that limit; {}",
      jump.count, jump.count == 1 ? "step" : "steps", jump.count == 1 ? "is" : "are",
      target_.steepestSlope, jump.slope, jump.u, jump.v, boxAdvice()));
}

std::string MeshSampler::boxAdvice() const {
  const Eigen::AlignedBox3d& extent = figures_.extent;
  return fmt::format("the mesh spans u {:.6g} to {:.6g}, v {:.6g} to {:.6g}; {}", extent.min().y(),
                     extent.max().y(), extent.min().z(), extent.max().z(),
                     figures_.suggestedBox
                         ? "a box without holes: " + inWords(*figures_.suggestedBox)
                         : "no box without holes was found");
}

}  // namespace morphgrid
