#pragma once
#include "print/print_verdict.h"
#include "report/run_record.h"

namespace morphgrid {

enum ExitCode {
  kConverged = 0,
  kBadInput = 2,
  kNotConverged = 3,
  kDeviceFailure = 4,
  kOutputLost = 5,
  kInterrupted = 130,
};

/// Warns of what the user should know of a run.
void logNotices(const RunRecord& record);

/// Prints the table of a run, and what its rows mean, or how to learn it.
void showTable(const RunRecord& record, bool explains);

/// Tells what could not be written.
void tellLostFiles(const std::vector<std::string>& lost);

/// The last line of a run: whether what it came to can be printed, or is of use; none where there
/// is nothing to say.
void tellVerdict(const PrintVerdict& verdict);

/// The exit code of a run that has just been made; says what helps where it did not converge.
int conclude(const RunRecord& record);

/// The same of a run that was finished before: warns where it had not come to rest.
int concludeFinished(const RunRecord& record);

}  // namespace morphgrid
