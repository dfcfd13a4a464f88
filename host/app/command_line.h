#pragma once

namespace morphgrid {

/// The program: parses the command line, does what it says, returns the exit code.
/// 0 converged, 2 bad input, 3 not converged (results written), 4 device failure or out of memory,
/// 5 standard output lost, 130 interrupted.
int runCommandLine(int argc, char** argv);

}  // namespace morphgrid
