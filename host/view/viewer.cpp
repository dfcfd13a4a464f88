#include "view/viewer.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <chrono>

#include "core/error.h"
#include "core/interrupt.h"
#include "gpu/offscreen_target.h"
#include "gpu/presenter.h"
#include "render/picture.h"
#include "view/frame_statistics.h"
#include "view/keyboard.h"
#include "view/overlay.h"
#include "view/scene_view.h"
#include "view/user_interface.h"

namespace morphgrid {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kFrameSeconds = 1.0 / 60;  // No more frames than screens show.
constexpr double kIdleSeconds = 0.25;       // Between looks at what else may have changed.
constexpr int kFramesAfterEvent = 4;        // Panels need some to settle.
constexpr double kPickReach = 7;            // Pixels.
constexpr double kStatisticsTurn = 0.01;    // Radians a frame.
constexpr double kWarmUpSeconds = 3;        // Before statistics: shaders are compiled.
constexpr double kRestSeconds = 1;          // At rest, before statistics solve again.
constexpr double kColorSeconds = 0.5;       // Between colours by distance while it changes.
constexpr int kPictureSamples = 4;
constexpr int kLiveQuads = 2000;  // Of surfaces, about.

double secondsBetween(Clock::time_point begin, Clock::time_point end) {
  return std::chrono::duration<double>(end - begin).count();
}

const char* nameOf(ShownStage stage) { return kStageNames[static_cast<std::size_t>(stage)]; }

bool isBusy(const Snapshot& snapshot) {
  return snapshot.activity == Activity::designing || snapshot.activity == Activity::solving;
}

/// Colours of struts that the host computes, kept until they are out of date.
class ColorCache {
 public:
  explicit ColorCache(const Device& device) : device_(device) {}

  /// Null, and the legend of strains, where strains are shown.
  std::shared_ptr<const StrutShares> sharesFor(Coloring coloring, const ShownGrid& shown,
                                               const Snapshot& snapshot) {
    if (coloring == Coloring::strain || !canColor(coloring, shown, snapshot)) {
      legend_ = strainLegend();
      onDevice_.reset();
      return nullptr;
    }
    const bool isSame = onDevice_ == shown.onDevice && coloring == coloring_ && shares_;
    const bool isNew = coloring != Coloring::distance || positions_ == shown.positions ||
                       secondsBetween(made_, Clock::now()) < kColorSeconds;
    if (!isSame || !isNew) {
      ColorShares colors = computeColors(coloring, shown, snapshot);
      shares_ = std::make_shared<StrutShares>(device_, colors.shares, colors.columns);
      shareLegend_ = std::move(colors.legend);
      coloring_ = coloring;
      onDevice_ = shown.onDevice;
      positions_ = shown.positions;
      made_ = Clock::now();
    }
    legend_ = shareLegend_;
    return shares_;
  }
  const Legend& legend() const { return legend_; }

 private:
  const Device& device_;
  Coloring coloring_ = Coloring::strain;
  std::shared_ptr<const DeviceGrid> onDevice_;
  std::shared_ptr<const Eigen::Matrix3Xd> positions_;
  std::shared_ptr<const StrutShares> shares_;
  Legend legend_ = strainLegend();
  Legend shareLegend_;
  Clock::time_point made_;
};

class Viewer {
 public:
  Viewer(const Device& device, Window& window, Session& session, const ViewerOptions& options)
      : device_(device),
        window_(window),
        session_(session),
        options_(options),
        presenter_(device, window.createSurface(device)),
        interface_(device, window, presenter_.format()),
        scene_(device, presenter_.format()),
        colors_(device),
        snapshot_(session.snapshot()),
        camera_(snapshot_->view.up) {}

  void run() {
    while (!window_.shouldClose() && !interruptRequested()) {
      handleEvents();
      const auto polled = Clock::now();
      isNew_ = snapshot_ != session_.snapshot();
      snapshot_ = session_.snapshot();
      window_.setTitle(fmt::format("{}, {}: {}", snapshot_->title,
                                   nameOf(stageOf(state_, *snapshot_)), snapshot_->status));
      if (frame()) {
        account(polled);
      }
      if (options_.statisticsSeconds) {
        driveStatistics();
      }
    }
    if (options_.statisticsSeconds) {
      printStatistics();
    }
  }

 private:
  void handleEvents() {
    const bool busy = isBusy(*snapshot_) || options_.statisticsSeconds;
    const double sinceFrame = secondsBetween(shown_, Clock::now());
    if (busy || framesLeft_ > 0) {
      window_.handleEvents(std::max(0.0, kFrameSeconds - sinceFrame));
      framesLeft_ = std::max(framesLeft_ - 1, 0);
    } else {
      const auto before = Clock::now();
      window_.handleEvents(kIdleSeconds);
      framesLeft_ = secondsBetween(before, Clock::now()) < kIdleSeconds ? kFramesAfterEvent : 0;
    }
  }

  SceneArea area() const {
    const vk::Extent2D size = presenter_.size();
    const int left =
        state_.showsPanels ? std::min(kPanelWidth, static_cast<int>(size.width) / 2) : 0;
    return {left, 0, std::max(1, static_cast<int>(size.width) - left),
            std::max(1, static_cast<int>(size.height))};
  }

  /// Frames all that there is, until the user looks elsewhere.
  void frameNewExtent() {
    const Eigen::AlignedBox3d& extent = snapshot_->extent;
    if (!extent.isEmpty() && !userLooks_ && !(framed_.isApprox(extent))) {
      camera_.frame(extent, snapshot_->view, area().aspect());
      framed_ = extent;
    }
  }

  /// Nothing moves, nobody does anything.
  bool isStill() const {
    return !isBusy(*snapshot_) && !isNew_ && framesLeft_ == 0 && !options_.statisticsSeconds;
  }
  Detail detail() const { return isStill() ? governor_.still() : governor_.detail(); }

  bool frame() {
    if (isStill() && isStillShown_) {
      return false;
    }
    if (window_.isMinimised() || !presenter_.prepare(window_.sizeInPixels())) {
      session_.noteFrame();
      window_.handleEvents(kIdleSeconds);
      return false;
    }
    if (presenter_.generation() != generation_) {
      generation_ = presenter_.generation();
      interface_.setImages(presenter_.size(), presenter_.views());
      scene_.setImages(presenter_.size(), presenter_.views());
    }
    frameNewExtent();
    std::vector<DrawnGrid> grids;
    interface_.build([&] {
      build();
      grids = drawnGrids();  // As the user has just chosen; the legend tells of them.
      buildOverlay();
    });
    const auto begin = Clock::now();
    const bool shown = presenter_.present([&](const vk::raii::CommandBuffer& commands,
                                              std::size_t image) {
      scene_.record(commands, image, detail().samples, grids, shownSampling(), cameraNow(), area());
      interface_.record(commands, image);
    });
    presenter_.waitForLast();
    if (!isStill()) {
      governor_.update(secondsBetween(begin, Clock::now()));
    }
    isStillShown_ = isStill() && shown;
    session_.noteFrame();
    return shown;
  }

  Camera cameraNow() const { return camera_.camera(snapshot_->extent, area().aspect()); }

  const std::optional<ShownGrid>& shownGrid() const {
    return snapshot_->stages[static_cast<std::size_t>(stageOf(state_, *snapshot_))];
  }

  /// Null unless that is what is shown.
  std::shared_ptr<const ShownSampling> shownSampling() const {
    return stageOf(state_, *snapshot_) == ShownStage::sampling ? snapshot_->sampling : nullptr;
  }

  void build() {
    const WindowActions actions{[&] { camera_.frameAgain(snapshot_->extent, area().aspect()); },
                                [&] { savePicture(); }};
    handleKeys(*snapshot_, state_, session_, actions, window_);
    if (!snapshot_->extent.isEmpty()) {
      const OrbitCamera before = camera_;
      const auto click = handleCamera(window_, camera_, snapshot_->extent, snapshot_->view, area());
      userLooks_ |= before.distance() != camera_.distance() || before.pivot() != camera_.pivot() ||
                    before.rotation() != camera_.rotation();
      if (click) {
        pick(*click);
      }
    }
    if (state_.showsPanels) {
      drawPanels(*snapshot_, state_, session_, actions, static_cast<int>(presenter_.size().height));
    }
    if (state_.showsHelp) {
      drawHelp(state_.showsHelp);
    }
    if (!picture_.empty()) {
      ImGui::GetForegroundDrawList()->AddText({static_cast<float>(area().left) + 12, 8},
                                              IM_COL32(40, 44, 52, 255), picture_.c_str());
    }
  }

  void buildOverlay() {
    if (snapshot_->extent.isEmpty()) {
      return;
    }
    drawAxes(cameraNow(), area());
    drawScaleBar(cameraNow(), camera_.pivot(), area());
    const auto& shown = shownGrid();
    if (!shown) {
      return;
    }
    if (isColored(state_, *snapshot_)) {
      drawLegend(colors_.legend(), area());
    }
    if (state_.picked && shown->grid && shown->positions &&
        std::max(state_.picked->from, state_.picked->to) < shown->positions->cols() &&
        state_.picked->layer < shown->grid->shape.layers) {
      drawStrutNumbers(*shown, *state_.picked);
      drawMark(cameraNow(), shown->worldFromGrid * shown->positions->col(state_.picked->from),
               shown->worldFromGrid * shown->positions->col(state_.picked->to), area());
    }
  }

  void pick(const glm::dvec2& pixel) {
    state_.picked.reset();
    const auto& shown = shownGrid();
    if (shown && shown->grid && shown->positions &&
        !looksLikeSurface(stageOf(state_, *snapshot_))) {
      const Eigen::Matrix3Xd placed = shown->worldFromGrid * *shown->positions;
      state_.picked = pickStrut(shown->grid->shape, placed, cameraNow().clipFromWorld(), area(),
                                pixel, kPickReach);
    }
  }

  std::vector<DrawnGrid> drawnGrids() {
    std::vector<DrawnGrid> grids;
    const auto& shown = shownGrid();
    if (!shown || !shown->onDevice) {
      return grids;
    }
    if (!(shown->onDevice->shape() == governed_)) {
      governed_ = shown->onDevice->shape();
      governor_.begin(governed_);
    }
    governor_.keepTo(state_.strutStyle);
    DrawnGrid drawn{*shown, {}, nullptr};
    drawn.look.isSurface = looksLikeSurface(stageOf(state_, *snapshot_));
    drawn.look.style = detail().style;
    drawn.look.stride = detail().stride;
    drawn.look.mostQuads = kLiveQuads;
    if (isColored(state_, *snapshot_)) {
      drawn.shares = colors_.sharesFor(state_.coloring, *shown, *snapshot_);
    }
    grids.push_back(std::move(drawn));
    const auto& target = snapshot_->stages[static_cast<std::size_t>(ShownStage::target)];
    const ShownStage stage = stageOf(state_, *snapshot_);
    if (state_.showsTarget && target && stage != ShownStage::target) {
      grids.push_back(
          {*target, {.isSurface = true, .isVeil = true, .mostQuads = kLiveQuads}, nullptr});
    }
    return grids;
  }

  /// Off screen, as fine as can be, with caption and legend.
  void savePicture() {
    try {
      PictureOptions picture;
      picture.caption =
          fmt::format("{}: {}", snapshot_->title, nameOf(stageOf(state_, *snapshot_)));
      if (isColored(state_, *snapshot_)) {
        picture.legend = colors_.legend();
      }
      const SceneSize size = sceneSize(picture);
      OffscreenTarget target(device_, static_cast<std::uint32_t>(size.width),
                             static_cast<std::uint32_t>(size.height), kPictureSamples);
      writePng(options_.pictureFile, composePicture(drawPicture(target, size), picture));
      picture_ = fmt::format("picture saved: {}", options_.pictureFile.string());
    } catch (const InputError& error) {
      picture_ = error.what();
    }
  }

  Image drawPicture(OffscreenTarget& target, const SceneSize& size) {
    const GridPainter painter(device_, target.renderPass(), target.samples());
    const Camera camera = camera_.camera(snapshot_->extent, size.aspect());
    std::vector<DrawnGrid> grids = drawnGrids();
    std::vector<std::unique_ptr<GridResources>> resources;
    std::optional<SamplingDrawing> sampling;
    if (const auto shown = shownSampling()) {
      sampling.emplace(device_, shown->mesh, shown->hits, target.renderPass(), target.samples());
    }
    return {
        size.width, size.height, target.render([&](const vk::raii::CommandBuffer& commands) {
          if (sampling) {
            sampling->draw(commands, camera, size.height);
          }
          for (DrawnGrid& drawn : grids) {
            const DeviceGrid& grid = *drawn.shown.onDevice;
            drawn.look.style = state_.strutStyle.value_or(StrutStyle::ribbons);
            drawn.look.stride = 1;
            drawn.look.mostQuads.reset();
            resources.push_back(std::make_unique<GridResources>(device_, grid, drawn.shares.get()));
            painter.draw(commands, *resources.back(), drawn.look,
                         viewOf(grid, drawn.shown.worldFromGrid, camera, size.height));
          }
        })};
  }

  void account(Clock::time_point polled) {
    const auto now = Clock::now();
    if (secondsBetween(begun_, now) > kWarmUpSeconds) {
      // The wait between them ends with an event.
      const double latency = secondsBetween(polled_, shown_) + secondsBetween(polled, now);
      statistics_.add(snapshot_->activity != Activity::atRest, secondsBetween(shown_, now),
                      latency);
    }
    shown_ = now;
    polled_ = polled;
  }

  void driveStatistics() {
    camera_.turn(kStatisticsTurn, 0);
    const auto now = Clock::now();
    if (snapshot_->activity != Activity::atRest) {
      rested_ = now;
    } else if (secondsBetween(rested_, now) > kRestSeconds) {
      rested_ = now;
      session_.restart();
    }
    if (secondsBetween(begun_, now) > kWarmUpSeconds + *options_.statisticsSeconds) {
      window_.close();
    }
  }

  void printStatistics() const {
    fmt::print("{} struts, {} x {} pixels, device {}\n{}", snapshot_->strutCount,
               presenter_.size().width, presenter_.size().height, device_.name(),
               statistics_.toText());
  }

  const Device& device_;
  Window& window_;
  Session& session_;
  const ViewerOptions& options_;
  Presenter presenter_;
  UserInterface interface_;
  SceneView scene_;
  ColorCache colors_;
  std::shared_ptr<const Snapshot> snapshot_;
  ViewState state_;
  OrbitCamera camera_;
  GridShape governed_{2, 2, 1};
  DetailGovernor governor_{governed_};
  FrameStatistics statistics_;
  std::string picture_;  ///< What became of the last one that was saved.
  int generation_ = 0;
  int framesLeft_ = kFramesAfterEvent;
  Eigen::AlignedBox3d framed_;
  bool userLooks_ = false;     ///< The camera is where the user has put it.
  bool isNew_ = true;          ///< The snapshot is not the last one's.
  bool isStillShown_ = false;  ///< What stands in the window needs no other frame.
  Clock::time_point begun_ = Clock::now();
  Clock::time_point shown_ = Clock::now();
  Clock::time_point polled_ = Clock::now();
  Clock::time_point rested_ = Clock::now();
};

}  // namespace

void runViewer(const Device& device, Window& window, Session& session,
               const ViewerOptions& options) {
  Viewer(device, window, session, options).run();
}

}  // namespace morphgrid
