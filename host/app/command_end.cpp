#include "app/command_end.h"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "core/visible_text.h"

namespace morphgrid {
namespace {

int exitCodeOf(const RunRecord& record) {
  const auto ended = [&](const auto& condition) {
    return (record.inPlane && condition(*record.inPlane)) ||
           (record.full && condition(*record.full));
  };
  if (record.deviceFailure) {
    return kDeviceFailure;
  }
  if (ended([](const Equilibrium& e) { return e.reason == StopReason::interrupted; })) {
    return kInterrupted;
  }
  return ended([](const Equilibrium& e) { return !e.converged; }) ? kNotConverged : kConverged;
}

}  // namespace

void logNotices(const RunRecord& record) {
  for (const std::string& notice : record.notices) {
    spdlog::warn(visibleText(notice, "\n"));
  }
}

void tellVerdict(const PrintVerdict& verdict) {
  if (const std::string line = verdict.line(); !line.empty()) {
    fmt::print("{}\n", visibleText(line));
  }
}

int conclude(const RunRecord& record) {
  const int exitCode = exitCodeOf(record);
  if (exitCode == kNotConverged) {
    spdlog::warn("not converged; try a higher solver.iteration_limit or a looser solver.tolerance");
  }
  return exitCode;
}

int concludeFinished(const RunRecord& record) {
  const Equilibrium& last = record.full ? *record.full : *record.inPlane;
  if (last.converged && record.inPlane->converged) {
    return kConverged;
  }
  spdlog::warn("the run did not converge ({}): this is where it stood", toString(last.reason));
  return kNotConverged;
}

}  // namespace morphgrid
