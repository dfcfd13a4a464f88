#include "app/command_end.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spdlog/spdlog.h>

#include "core/visible_text.h"
#include "report/explain_table.h"
#include "report/report_table.h"

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
  if (record.isInterrupted) return kInterrupted;
  if (!record.lostFiles.empty()) {
    return kOutputLost;
  }
  return ended([](const Equilibrium& e) { return !e.converged; }) ? kNotConverged : kConverged;
}

}  // namespace

void logNotices(const RunRecord& record) {
  for (const Notice& notice : record.notices) {
    spdlog::warn(visibleText(notice.text, "\n"));
  }
}

void tellVerdict(const PrintVerdict& verdict) {
  if (const std::string line = verdict.line(); !line.empty()) {
    fmt::print("{}\n", visibleText(line));
  }
}

void showTable(const RunRecord& record, bool explains) {
  const std::string table = toTable(record);
  fmt::print("{}{}", table,
             explains ? explainTable(table) : "  (--explain says what the rows mean)\n");
}

void tellLostFiles(const std::vector<std::string>& lost) {
  if (lost.empty()) return;
  fmt::print(stderr, "{} could not be written:\n{}\n",
             lost.size() == 1 ? "a file" : fmt::format("{} files", lost.size()),
             visibleText(fmt::format("{}", fmt::join(lost, "\n")), "\n"));
}

int conclude(const RunRecord& record) {
  const int exitCode = exitCodeOf(record);
  if (exitCode == kNotConverged) {
    spdlog::warn("not converged; try a higher solver.iteration_limit or a looser solver.tolerance");
  }
  tellLostFiles(record.lostFiles);
  return exitCode;
}

int concludeFinished(const RunRecord& record) {
  const Equilibrium& last = record.full ? *record.full : *record.inPlane;
  const bool isConverged = last.converged && record.inPlane->converged;
  if (!isConverged) {
    spdlog::warn("the run did not converge ({}): this is where it stood", toString(last.reason));
  }
  tellLostFiles(record.lostFiles);
  return !record.lostFiles.empty() ? kOutputLost : isConverged ? kConverged : kNotConverged;
}

}  // namespace morphgrid
