#pragma once
#include <functional>
#include <string>
#include <vector>

namespace morphgrid {

struct ProcessResult {
  int exitCode;        ///< 128 + signal when a signal ended it.
  std::string output;  ///< stdout and stderr.
};

/// Runs the morphgrid program with these arguments; environment: more `NAME=value`s. When
/// interruptAfterSeconds > 0, SIGINT is sent then.
ProcessResult runMorphgrid(const std::vector<std::string>& arguments,
                           const std::vector<std::string>& environment = {},
                           double interruptAfterSeconds = 0);

/// Runs it and sends the signal once `done` says so, which is asked over and over.
ProcessResult runMorphgridUntil(const std::function<bool(const std::string& output)>& done,
                                const std::vector<std::string>& arguments, int signal);

}  // namespace morphgrid
