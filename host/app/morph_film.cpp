#include "app/morph_film.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "app/progress_line.h"
#include "core/rigid_alignment.h"
#include "export/gltf_morph.h"
#include "grid/move_joints.h"
#include "render/webp_animation.h"

namespace morphgrid {
namespace {

using Shapes = std::vector<Eigen::Matrix3Xd>;
using Turns = std::vector<JointRotations>;  // Of a frame's joints, as long as Shapes.
using Placements = std::vector<Eigen::Isometry3d>;

// Seconds.
constexpr double kFirstShown = 0.5;
constexpr double kMorphing = 3;
constexpr double kLastShown = 1.5;

constexpr int kMostKeys = 13;         // Shapes in the glTF file, which grows with each.
constexpr int kFewestDone = 3;        // Steps or frames that tell a rate.
constexpr int kMorphRefinement = 2;   // Cells of its surface per grid cell, along u and v.
constexpr double kSameEnergy = 1e-3;  // Equilibria of a smaller relative difference are the same.

/// Tells on stderr how a count goes on.
class Counter {
 public:
  Counter(const char* what, int count, bool quiet) : what_(what), count_(count), quiet_(quiet) {}

  void tell(int done) {
    if (!quiet_) {
      const double seconds =
          std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
      line_.tell(fmt::format("{} {} of {}", what_, done, count_), seconds,
                 done >= kFewestDone ? seconds / done * (count_ - done) : -1);
    }
  }

 private:
  const char* what_;
  int count_;
  bool quiet_;
  ProgressLine line_{"morph", 0};
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

struct Morph {
  MorphCourse course;
  Turns turns;
};

Morph follow(const Scene& scene, const Device& device, const StrutGrid& grid, int steps,
             bool quiet) {
  Counter counter("equilibrium", steps, quiet);
  MultigridSolver solver(device, grid);
  Turns turns{turnWithBars(grid, grid.positions)};
  MorphCourse course =
      followMorph(solver, {steps, scene.solve, [&](int step, const Equilibrium& at) {
                             turns.push_back(at.rotations);
                             counter.tell(step);
                           }});
  return {std::move(course), std::move(turns)};
}

/// Motions that bring the last shape to `end`, and each other one to the one after it: nothing but
/// the morph is left to see. Shapes of a grid that is held lie where they should to each other.
Placements placeShapes(const Shapes& shapes, const Eigen::Matrix3Xd& end, bool isHeld) {
  Placements placements(shapes.size());
  Eigen::Matrix3Xd next = end;
  for (std::size_t n = shapes.size(); n-- > 0;) {
    placements[n] = alignRigidly(shapes[n], next);
    if (isHeld) {
      placements.assign(shapes.size(), placements[n]);
      break;
    }
    next = placements[n] * shapes[n];
  }
  return placements;
}

Camera frameShapes(const Shapes& shapes, const Placements& placements, const View& view,
                   double aspect) {
  const Eigen::Index count = shapes.front().cols();
  Eigen::Matrix3Xd points(3, count * static_cast<Eigen::Index>(shapes.size()));
  for (std::size_t n = 0; n < shapes.size(); ++n) {
    points.middleCols(static_cast<Eigen::Index>(n) * count, count) = placements[n] * shapes[n];
  }
  return frameAll(points, view.direction, view.up, aspect);
}

double secondsShown(int frame, int frameCount) {
  const double between = kMorphing / (frameCount - 1);
  return frame == 0 ? kFirstShown + between : frame == frameCount - 1 ? kLastShown : between;
}

std::filesystem::path framePath(const std::filesystem::path& folder, int frame) {
  return folder / fmt::format("frame_{:04}.png", frame);
}

/// Removes frames from this number on: a longer film before this one may have left them.
void removeFramesFrom(const std::filesystem::path& folder, int frame) {
  std::error_code ignored;
  while (std::filesystem::remove(framePath(folder, frame), ignored)) {
    ++frame;
  }
}

/// Shapes on the same grid, coloured by the strain to the designed lengths.
void drawFrames(const Scene& scene, const View& view, const Device& device, DeviceGrid& deviceGrid,
                const Shapes& shapes, const Turns& turns, const Placements& placements,
                const FilmOptions& options, OutputFiles& files, bool quiet) {
  PictureOptions picture{.width = scene.pictures.width,
                         .height = scene.pictures.height,
                         .caption = {},
                         .legend = strainLegend()};
  const SceneSize size = sceneSize(picture);
  const Camera camera = frameShapes(shapes, placements, view, size.aspect());
  StrainRenderer renderer(device, size.width, size.height);
  WebpAnimation animation(picture.width, picture.height);
  const int count = static_cast<int>(shapes.size());
  Counter counter("frame", count, quiet);
  const std::size_t lostBefore = files.lost().size();
  for (int n = 0; n < count; ++n) {
    const auto index = static_cast<std::size_t>(n);
    deviceGrid.uploadPositions(shapes[index], turns[index]);
    picture.caption = fmt::format("morph: {:.0f} % of the shrinkage", 100.0 * n / (count - 1));
    const Image frame =
        composePicture(renderer.drawStruts(deviceGrid, placements[index], camera), picture);
    // Where one frame cannot be written, none is told for each of the others.
    if (!options.framesFolder.empty() && files.lost().size() == lostBefore) {
      files.writeAt(framePath(options.framesFolder, n),
                    [&](const auto& path) { writePng(path, frame); });
    }
    if (!options.animation.empty()) {
      animation.add(frame, static_cast<int>(std::lround(1000 * secondsShown(n, count))));
    }
    counter.tell(n + 1);
  }
  if (!options.framesFolder.empty()) {
    removeFramesFrom(options.framesFolder, count);
  }
  if (!options.animation.empty()) {
    files.writeAt(options.animation, [&](const auto& path) { animation.write(path); });
  }
}

void writeGltf(const std::filesystem::path& path, const StrutGrid& grid, const Shapes& shapes,
               const Turns& turns, const Placements& placements) {
  const int steps = static_cast<int>(shapes.size()) - 1;
  const int lastKey = std::min(steps, kMostKeys - 1);
  std::vector<MorphKey> keys;
  std::vector<MorphMoment> timeline{{0, 0}};
  for (int key = 0; key <= lastKey; ++key) {
    const int step = static_cast<int>(std::lround(double(key) * steps / lastKey));
    const auto index = static_cast<std::size_t>(step);
    Eigen::Matrix3Xd positions = placements[index] * shapes[index];
    SurfaceMesh surface =
        tessellate(grid.shape, middleLayer(grid.shape, positions), kMorphRefinement);
    keys.push_back(
        {std::move(positions), std::move(surface), moveJoints(placements[index], turns[index])});
    timeline.push_back({kFirstShown + kMorphing * step / steps, key});
  }
  timeline.push_back({kFirstShown + kMorphing + kLastShown, lastKey});
  exportGltfMorph(path, grid, keys, timeline);
}

FilmRecord recordOf(const MorphCourse& course, const Equilibrium& simulation) {
  FilmRecord record{course.unconverged == 0, {}};
  if (!record.converged) {
    record.notices.push_back(fmt::format("{} of the morph's {} steps did not converge",
                                         course.unconverged, course.positions.size() - 1));
  }
  if (std::abs(course.end.energy - simulation.energy) > kSameEnergy * std::abs(simulation.energy)) {
    record.notices.push_back(fmt::format(
        "the slow morph ends in another equilibrium than the simulation: its energy is {:.6g}, not "
        "{:.6g}",
        course.end.energy, simulation.energy));
  }
  return record;
}

}  // namespace

FilmRecord filmMorph(const Scene& scene, const SceneDesign& designed, const Device& device,
                     Simulation& simulation, const FilmOptions& options, OutputFiles& files,
                     bool quiet) {
  Stage& stage = simulation.stage;
  const auto [course, turns] = follow(scene, device, stage.grid, options.frameCount - 1, quiet);
  const Placements placements =
      placeShapes(course.positions, simulation.targetFromGrid * stage.equilibrium.positions,
                  stage.grid.bars && stage.grid.bars->loads);
  if (!options.framesFolder.empty() || !options.animation.empty()) {
    drawFrames(scene, designed.view(), device, *stage.onDevice, course.positions, turns, placements,
               options, files, quiet);
  }
  if (!options.gltf.empty()) {
    files.writeAt(options.gltf, [&, &shapes = course.positions, &angles = turns](const auto& path) {
      writeGltf(path, stage.grid, shapes, angles, placements);
    });
  }
  return recordOf(course, stage.equilibrium);
}

}  // namespace morphgrid
