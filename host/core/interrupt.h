#pragma once

namespace morphgrid {

/// From here on Ctrl-C and SIGTERM ask long work to stop cleanly; a second one ends the program.
void installInterruptHandler();

/// True once the user has asked to stop.
bool interruptRequested();

/// 0 before.
double secondsSinceInterrupt();

}  // namespace morphgrid
