// How long each phase of a command takes to end after Ctrl-C.
#include <fmt/format.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "benchmark/child_process.h"
#include "benchmark/disturbed_runs.h"

namespace morphgrid {
namespace {

constexpr double kMostSeconds = 2;
constexpr int kInterruptedExit = 130;

using Arguments = std::vector<std::string>;
using Clock = std::chrono::steady_clock;

/// A moment of a command: once it has told `told` or written `file`, then so many seconds later.
struct Phase {
  const char* name;
  Arguments arguments;
  std::string told;
  std::string file;
  double later = 0;
};

double secondsFrom(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

Arguments with(Arguments arguments, const std::vector<std::string>& values) {
  for (const std::string& value : values) arguments.insert(arguments.end(), {"--set", value});
  return arguments;
}

std::vector<Phase> phasesOf(const DisturbedPlace& place) {
  const std::string out = place.folder / "interrupted";
  const auto run = [&](const char* scene) {
    return Arguments{"run", place.scene(scene), "--out", out};
  };
  const std::vector<std::string> trueShape{"true_shape=true", "grid.nodes_long=80",
                                           "output.pictures=false"};
  return {
      {"measuring, 1800 nodes", with(run("cup"), {"grid.nodes_long=1800"}), "", "", 0.5},
      {"measuring, 1500 nodes, orthogonal net",
       with(run("patch"), {"grid.nodes_long=1500", "design.net=orthogonal"}), "", "", 1},
      {"a strip of half a million nodes",
       with(run("strip"), {"grid.nodes_u=500000", "grid.nodes_v=1"}), "", "", 0.5},
      {"in plane, 800 nodes", with(run("cup"), {"grid.nodes_long=800"}), "", "", 4},
      {"full stage, 800 nodes", with(run("cup"), {"grid.nodes_long=800"}), "full:", "", 0},
      {"full stage, jacobi",
       with(run("egg_chair"), {"grid.nodes_long=100", "solver.method=jacobi"}), "full:", "", 0},
      {"full stage, reference",
       with(run("egg_chair"), {"grid.nodes_long=120", "solver.method=reference"}), "full:", "", 0},
      {"inverse design", with(run("iris_petal"), trueShape), "inverse design: step", "", 0},
      {"check from flat",
       with(run("iris_petal"), {"true_shape=true", "grid.nodes_long=120", "output.pictures=false",
                                "design.optimise=0", "design.compensate=1"}),
       "check from flat", "", 0},
      {"writing files, 200 nodes",
       with(run("cup"), {"grid.nodes_long=200", "output.pictures=false"}), "", "report.json", 0},
      {"pictures of 8192 x 8192",
       with(run("patch"), {"grid.nodes_long=6", "output.width=8192", "output.height=8192"}), "",
       "state.safetensors", 1},
      {"figures: its animation",
       {"figures", place.scene("egg_chair"), "--out", out + "/sheet.png", "--animation",
        out + "/morph.webp", "--frame-count", "1000"},
       "",
       "sheet.png",
       1},
      {"check", with({"check", place.scene("cup")}, {"grid.nodes_long=1800"}), "", "", 0.5},
      {"new: proposing", {"new", place.scenes / "meshes/torso.ply", "--out", out}, "", "", 1},
  };
}

struct InterruptedRun {
  bool isReached;
  double seconds = 0;
  int exitCode = 0;
  std::size_t half = 0;
};

InterruptedRun interruptOnce(const DisturbedPlace& place, const Phase& phase, int signal) {
  const std::filesystem::path out = emptyFolder(place.folder / "interrupted");
  const std::filesystem::path output = place.folder / "output";
  std::filesystem::remove(output);  // What the run before told would be taken for this one's.
  ChildProcess run(place.program, phase.arguments, output);
  const bool isReached = run.waitFor([&] {
    return (phase.told.empty() || run.output().find(phase.told) != std::string::npos) &&
           (phase.file.empty() || std::filesystem::exists(out / phase.file));
  });
  std::this_thread::sleep_for(std::chrono::duration<double>(phase.later));
  if (!isReached || run.hasEnded()) return {.isReached = false};
  const auto start = Clock::now();
  run.signal(signal);
  const int exitCode = run.exitCode();
  return {true, secondsFrom(start), exitCode,
          listHalfFiles(out).size() + static_cast<std::size_t>(countTemporaries(out))};
}

}  // namespace

std::string interruptPhases(const DisturbedPlace& place, bool& isWell) {
  std::string rows;
  int count = 0, inTime = 0;
  double longest = 0;
  for (const Phase& phase : phasesOf(place)) {
    for (const auto& [signal, name] :
         {std::pair(SIGINT, "Ctrl-C"), std::pair(SIGTERM, "SIGTERM")}) {
      const InterruptedRun ended = interruptOnce(place, phase, signal);
      ++count;
      if (!ended.isReached) {
        rows += fmt::format("| {} | {} | **not reached** | | |\n", phase.name, name);
        continue;
      }
      const bool isRight =
          ended.seconds <= kMostSeconds && ended.half == 0 && ended.exitCode == kInterruptedExit;
      inTime += isRight;
      longest = std::max(longest, ended.seconds);
      rows +=
          fmt::format("| {} | {} | {}{:.2f}{} | {} | {} |\n", phase.name, name, isRight ? "" : "**",
                      ended.seconds, isRight ? "" : "**", ended.exitCode, ended.half);
    }
  }
  isWell = isWell && inTime == count;
  return fmt::format(
      "### Interrupted\n\n"
      "Ctrl-C and SIGTERM in each phase: {} of {} ended within {:g} s, with exit code {} and no "
      "half "
      "or temporary file; the longest\ntook {:.2f} s.\n\n"
      "| phase | signal | ended after, s | exit code | half or temporary |\n"
      "| --- | --- | --- | --- | --- |\n{}",
      inTime, count, kMostSeconds, kInterruptedExit, longest, rows);
}

}  // namespace morphgrid
