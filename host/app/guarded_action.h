#pragma once
#include "app/commands.h"

namespace morphgrid {

/// Does it. What it throws becomes a line on standard error, control characters made visible, and
/// an ExitCode; what is a bug of the program's is thrown on.
int runGuarded(const Action& action);

}  // namespace morphgrid
