#include "app/step_gate.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

namespace morphgrid {
namespace {

using std::chrono_literals::operator""ms;

/// A solver that passes the gate again and again, without frames to wait for.
class GatedSolver : public testing::Test {
 protected:
  GatedSolver() { gate_.showEveryStep(false); }
  ~GatedSolver() override {
    isCancelled_ = true;
    gate_.wake();
    solver_.join();
  }

  void start() {
    solver_ = std::thread([this] {
      while (!isCancelled_) {
        gate_.pass([this] { return isCancelled_.load(); }, [this] { ++held_; });
        ++steps_;
      }
    });
  }
  /// Waits until the solver is held; returns the steps that it has done.
  long stepsWhenHeld() {
    const long before = held_;
    while (held_ < before + 2) {  // The first may have been counted before a step.
      std::this_thread::sleep_for(1ms);
    }
    return steps_;
  }

  StepGate gate_;
  std::atomic<bool> isCancelled_ = false;
  std::atomic<long> held_ = 0;
  std::atomic<long> steps_ = 0;
  std::thread solver_;
};

TEST_F(GatedSolver, StopsWhilePausedAndGoesOn) {
  gate_.pause(true);
  start();
  EXPECT_EQ(stepsWhenHeld(), 0);
  gate_.pause(false);
  while (steps_ < 100) {
    std::this_thread::yield();
  }
  gate_.pause(true);
  const long steps = stepsWhenHeld();
  EXPECT_EQ(stepsWhenHeld(), steps);
}

TEST_F(GatedSolver, DoesAsManyStepsAsAskedFor) {
  gate_.pause(true);
  start();
  for (const long step : {1, 2, 3}) {
    gate_.step();
    EXPECT_EQ(stepsWhenHeld(), step);
  }
}

TEST_F(GatedSolver, ThatIsCancelledIsNotHeld) {
  gate_.pause(true);
  start();
  stepsWhenHeld();  // The end of the test would hang.
}

TEST(StepGate, WaitsForAFrameThatBeganAfterTheStep) {
  StepGate gate(std::chrono::hours(1));  // Nothing but frames ends the wait.
  std::atomic<bool> passed = false;
  std::thread solver([&] {
    gate.pass([] { return false; }, [] {});
    passed = true;
  });
  long frames = 0;
  for (; !passed; ++frames) {
    gate.noteFrame();
    std::this_thread::sleep_for(1ms);
  }
  solver.join();
  EXPECT_GE(frames, 2) << "the first may have begun before the step";
}

TEST(StepGate, DoesNotWaitForWindowsWithoutFrames) {
  StepGate gate;
  gate.pass([] { return false; }, [] {});
}

}  // namespace
}  // namespace morphgrid
