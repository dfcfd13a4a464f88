// Runs with inverse design that are killed at random moments and go on from their checkpoint.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <chrono>
#include <cmath>
#include <csignal>
#include <nlohmann/json.hpp>
#include <random>
#include <thread>

#include "app/checkpoint.h"
#include "benchmark/child_process.h"
#include "benchmark/disturbed_runs.h"
#include "core/read_file.h"

namespace morphgrid {
namespace {

constexpr int kKills = 20;
// Of the undisturbed run's: steps of a line search end where the solver's tolerance lets them.
constexpr double kSameDistance = 0.02;

using Arguments = std::vector<std::string>;

struct End {
  double rmsPercent = 0;
  std::size_t steps = 0;
};

struct KilledRun {
  double seconds;     ///< After which it was killed.
  std::string where;  ///< What it was at, as its checkpoint tells.
  std::size_t half;
  int temporaries;       ///< That it left.
  int temporariesAfter;  ///< That the resumed run left.
  int exitCode;          ///< Of the resumed run.
  End end;
};

Arguments runOf(const DisturbedPlace& place, const std::string& out, const Arguments& more = {}) {
  Arguments arguments{"run", place.scene("egg_chair_true"), "--quiet", "--out", place.folder / out};
  for (const char* value : {"grid.nodes_long=14", "design.compensate=3", "design.optimise=8",
                            "output.width=320", "output.height=240"}) {
    arguments.insert(arguments.end(), {"--set", value});
  }
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

End endOf(const std::filesystem::path& out) {
  const auto report = nlohmann::json::parse(readFile(out / "report.json"));
  return {report["distance_to_target"]["rms_percent"], report["inverse_design"]["steps"].size()};
}

std::string whereItStood(const std::filesystem::path& out,
                         const std::filesystem::path& checkpoint) {
  if (std::filesystem::exists(out / "report.json")) return "writing files";
  if (!std::filesystem::exists(checkpoint)) return "no checkpoint yet";
  const Checkpoint read = readCheckpoint(checkpoint);
  if (read.inverse) return fmt::format("inverse design, step {}", read.inverse->steps.size());
  return read.inPlane ? "full stage" : "in plane";
}

KilledRun killOnce(const DisturbedPlace& place, double seconds) {
  const std::filesystem::path out = emptyFolder(place.folder / "killed");
  const std::filesystem::path checkpoint = place.folder / "checkpoint";
  std::filesystem::remove(checkpoint);
  {
    ChildProcess run(
        place.program,
        runOf(place, "killed", {"--checkpoint", checkpoint, "--checkpoint-minutes", "0.002"}),
        place.folder / "output");
    const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
    run.waitFor([&] { return std::chrono::steady_clock::now() >= end; });
    run.signal(SIGKILL);
    run.exitCode();
  }
  KilledRun killed{seconds,
                   whereItStood(out, checkpoint),
                   listHalfFiles(out).size(),
                   countTemporaries(out) + countTemporaries(place.folder),
                   0,
                   0,
                   {}};
  Arguments resuming{"--checkpoint", checkpoint};  // Its temporaries are to be removed, too.
  if (std::filesystem::exists(checkpoint))
    resuming.insert(resuming.end(), {"--resume", checkpoint});
  killed.exitCode =
      ChildProcess(place.program, runOf(place, "killed", resuming), place.folder / "output")
          .exitCode();
  killed.temporariesAfter = countTemporaries(out) + countTemporaries(place.folder);
  if (killed.exitCode == 0) killed.end = endOf(out);
  return killed;
}

}  // namespace

std::string killAndResume(const DisturbedPlace& place, bool& isWell) {
  const auto start = std::chrono::steady_clock::now();
  ChildProcess(place.program, runOf(place, "whole"), place.folder / "output").exitCode();
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const End whole = endOf(place.folder / "whole");
  std::mt19937 random(17);
  std::uniform_real_distribution<double> moments(0, seconds);
  std::string rows;
  int same = 0, clean = 0;
  double farthest = 0;
  for (int n = 0; n < kKills; ++n) {
    const KilledRun killed = killOnce(place, moments(random));
    const double difference = std::abs(killed.end.rmsPercent / whole.rmsPercent - 1);
    const bool isSame = killed.exitCode == 0 && difference <= kSameDistance;
    same += isSame;
    clean += killed.half == 0 && killed.temporariesAfter == 0;
    farthest = std::max(farthest, difference);
    rows += fmt::format("| {:.2f} | {} | {} | {} | {} | {} | {} | {}{:.1e}{} |\n", killed.seconds,
                        killed.where, killed.half, killed.temporaries, killed.temporariesAfter,
                        killed.exitCode, killed.end.steps, isSame ? "" : "**", difference,
                        isSame ? "" : "**");
  }
  isWell = isWell && same == kKills && clean == kKills;
  return fmt::format(
      "### Killed and resumed\n\n"
      "`kill -9` at {} random moments of a run of {:.1f} s with inverse design ({} steps, ending "
      "{:.4g} % from the target),\nthen `--resume`, or anew where there was no checkpoint yet. "
      "{} of {} ended within {:g} % of that distance, the farthest\n{:.1e} of it off; {} of {} "
      "left "
      "neither a half file under a final name nor, once resumed, a temporary one.\n\n"
      "| killed after, s | at | half files | temporaries | after resuming | exit code | steps | "
      "distance differs by |\n| --- | --- | --- | --- | --- | --- | --- | --- |\n{}",
      kKills, seconds, whole.steps - 1, whole.rmsPercent, same, kKills, 100 * kSameDistance,
      farthest, clean, kKills, rows);
}

}  // namespace morphgrid
