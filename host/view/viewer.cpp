#include "view/viewer.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <chrono>

#include "core/error.h"
#include "core/interrupt.h"
#include "gpu/presenter.h"
#include "view/frame_benchmark.h"
#include "view/keyboard.h"
#include "view/overlay.h"
#include "view/user_interface.h"
#include "view/view_picture.h"

namespace morphgrid {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kFrameSeconds = 1.0 / 60;  // No more frames than screens show.
constexpr double kIdleSeconds = 0.25;       // Between looks at what else may have changed.
constexpr int kFramesAfterEvent = 4;        // Panels need some to settle.
constexpr double kPickReach = 7;            // Pixels.

double secondsBetween(Clock::time_point begin, Clock::time_point end) {
  return std::chrono::duration<double>(end - begin).count();
}

const char* nameOf(ShownStage stage) { return kStageNames[static_cast<std::size_t>(stage)]; }

bool isBusy(const Snapshot& snapshot) {
  return snapshot.activity == Activity::designing || snapshot.activity == Activity::solving;
}

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
        list_(device),
        snapshot_(session.snapshot()),
        camera_(snapshot_->view.up) {
    if (options.statisticsSeconds) {
      benchmark_.emplace(*options.statisticsSeconds);
    }
  }

  void run() {
    while (!window_.shouldClose() && !interruptRequested()) {
      handleEvents();
      const auto polled = Clock::now();
      isNew_ = snapshot_ != session_.snapshot();
      snapshot_ = session_.snapshot();
      window_.setTitle(
          fmt::format("{}, {}: {}", snapshot_->title, nameOf(stage()), snapshot_->status));
      if (frame()) {
        account(polled);
      }
      if (benchmark_) {
        benchmark_->act(*snapshot_, session_, camera_);
        if (benchmark_->isOver()) {
          window_.close();
        }
      }
    }
    if (benchmark_) {
      printStatistics();
    }
  }

 private:
  void handleEvents() {
    const bool busy = isBusy(*snapshot_) || benchmark_;
    const double sinceFrame = secondsBetween(shown_, Clock::now());
    if (busy || framesLeft_ > 0) {
      window_.handleEvents(std::max(0.0, kFrameSeconds - sinceFrame));
      framesLeft_ = std::max(framesLeft_ - 1, 0);
    } else {
      framesLeft_ = window_.handleEvents(kIdleSeconds) ? kFramesAfterEvent : 0;
    }
  }

  SceneArea area() const {
    const PixelSize size = presenter_.size();
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
  bool isStill() const { return !isBusy(*snapshot_) && !isNew_ && framesLeft_ == 0 && !benchmark_; }

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
    interface_.build([&] {
      build();
      list_.collect(*snapshot_, state_, isStill());  // As the user has just chosen.
      buildOverlay();
    });
    window_.forgetKeys();
    return present();
  }

  bool present() {
    const auto begin = Clock::now();
    const bool shown = presenter_.present([&](const CommandBuffer& commands, std::size_t image) {
      scene_.record(commands, image, list_.samples(), list_.grids(), list_.sampling(), cameraNow(),
                    area());
      interface_.record(commands, image);
    });
    presenter_.waitForLast();
    if (!isStill()) {
      list_.noteFrame(secondsBetween(begin, Clock::now()));
    }
    isStillShown_ = isStill() && shown;
    session_.noteFrame();
    return shown;
  }

  Camera cameraNow() const { return camera_.camera(snapshot_->extent, area().aspect()); }

  ShownStage stage() const { return stageOf(state_, *snapshot_); }
  const std::optional<ShownGrid>& shownGrid() const { return gridOf(stage(), *snapshot_); }

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
    if (list_.legend()) {
      drawLegend(*list_.legend(), area());
    }
    if (state_.picked && shown->grid && shown->positions &&
        std::max(state_.picked->from, state_.picked->to) < shown->positions->cols() &&
        state_.picked->layer < shown->grid->shape.layers) {
      drawStrutNumbers(*snapshot_, *shown, *state_.picked);
      drawMark(cameraNow(), shown->worldFromGrid * shown->positions->col(state_.picked->from),
               shown->worldFromGrid * shown->positions->col(state_.picked->to), area());
    }
  }

  void pick(const glm::dvec2& pixel) {
    state_.picked.reset();
    const auto& shown = shownGrid();
    if (shown && shown->grid && shown->positions && !looksLikeSurface(stage())) {
      const Eigen::Matrix3Xd placed = shown->worldFromGrid * *shown->positions;
      state_.picked = pickStrut(shown->grid->shape, placed, cameraNow().clipFromWorld(), area(),
                                pixel, kPickReach);
    }
  }

  void savePicture() {
    try {
      list_.collect(*snapshot_, state_, true);
      saveViewPicture(options_.pictureFile, device_, list_,
                      fmt::format("{}: {}", snapshot_->title, nameOf(stage())),
                      [&](double aspect) { return camera_.camera(snapshot_->extent, aspect); });
      picture_ = fmt::format("picture saved: {}", options_.pictureFile.string());
    } catch (const InputError& error) {
      picture_ = error.what();
    }
  }

  void account(Clock::time_point polled) {
    const auto now = Clock::now();
    if (benchmark_) {
      // The wait between them ends with an event.
      const double latency = secondsBetween(polled_, shown_) + secondsBetween(polled, now);
      benchmark_->noteFrame(*snapshot_, secondsBetween(shown_, now), latency);
    }
    shown_ = now;
    polled_ = polled;
  }

  void printStatistics() const {
    fmt::print("{} struts, {} x {} pixels, device {}\n{}", snapshot_->strutCount,
               presenter_.size().width, presenter_.size().height, device_.name(),
               benchmark_->toText());
  }

  const Device& device_;
  Window& window_;
  Session& session_;
  const ViewerOptions& options_;
  Presenter presenter_;
  UserInterface interface_;
  SceneView scene_;
  DrawList list_;
  std::shared_ptr<const Snapshot> snapshot_;
  ViewState state_;
  OrbitCamera camera_;
  std::optional<FrameBenchmark> benchmark_;
  std::string picture_;  ///< What became of the last one that was saved.
  int generation_ = 0;
  int framesLeft_ = kFramesAfterEvent;
  Eigen::AlignedBox3d framed_;
  bool userLooks_ = false;     ///< The camera is where the user has put it.
  bool isNew_ = true;          ///< The snapshot is not the last one's.
  bool isStillShown_ = false;  ///< What stands in the window needs no other frame.
  Clock::time_point shown_ = Clock::now();
  Clock::time_point polled_ = Clock::now();
};

}  // namespace

void runViewer(const Device& device, Window& window, Session& session,
               const ViewerOptions& options) {
  Viewer(device, window, session, options).run();
}

}  // namespace morphgrid
