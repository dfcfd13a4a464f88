#pragma once
#include "app/commands.h"

namespace morphgrid {

/// Does it. What it throws becomes a line on standard error, control characters made visible, and
/// an ExitCode; what is a bug of the program's is thrown on.
int runGuarded(const Action& action);

/// Writes what standard output still holds. Returns the exit code; where that was of success, and
/// output was lost, kOutputLost. Tells of it on standard error.
int withOutputWritten(int exitCode);

/// Puts something in the place of standard streams that are closed: the next file that is opened
/// would else be taken for one of them, and get what is printed.
void reserveStandardStreams();

}  // namespace morphgrid
