#include "view/frame_benchmark.h"

namespace morphgrid {
namespace {

constexpr double kTurn = 0.01;            // Radians a frame.
constexpr double kWarmUpSeconds = 3;      // Shaders are compiled.
constexpr std::chrono::seconds kRest(1);  // At rest, before it solves again.

}  // namespace

double FrameBenchmark::secondsOfMeasuring() const {
  return std::chrono::duration<double>(Clock::now() - begun_).count() - kWarmUpSeconds;
}

void FrameBenchmark::noteFrame(const Snapshot& snapshot, double seconds, double latency) {
  if (secondsOfMeasuring() > 0) {
    statistics_.add(snapshot.activity != Activity::atRest, seconds, latency);
  }
}

void FrameBenchmark::act(const Snapshot& snapshot, Session& session, OrbitCamera& camera) {
  camera.turn(kTurn, 0);
  const auto now = Clock::now();
  if (snapshot.activity != Activity::atRest) {
    rested_ = now;
  } else if (now - rested_ > kRest) {
    rested_ = now;
    session.restart();
  }
}

bool FrameBenchmark::isOver() const { return secondsOfMeasuring() > seconds_; }

}  // namespace morphgrid
