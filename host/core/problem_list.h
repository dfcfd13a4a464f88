#pragma once
#include <string>
#include <vector>

#include "core/error.h"

namespace morphgrid {

/// Where in the input something stands.
struct Place {
  std::string source;  ///< A file, or `--set key=value`.
  int line = 0;        ///< From 1; 0 where the source has no lines.
  int column = 0;      ///< From 1, in characters.

  bool operator==(const Place&) const = default;
};

/// `source:line:column`, or `source` where there are no lines.
std::string toString(const Place& place);

/// `place: what`, or `what` alone where the place is empty.
InputError errorAt(const Place& place, const std::string& what);

/// Collects what is wrong with an input, so that the user learns of everything at once.
class ProblemList {
 public:
  void add(Place place, std::string text);
  /// Takes over the lines of an error found in another input.
  void add(const InputError& error);

  bool empty() const { return problems_.empty(); }

  /// Throws InputError with one problem a line, by file and line; then those of sources without
  /// lines, then those of other inputs.
  void throwIfAny() const;

 private:
  struct Problem {
    Place place;
    std::string text;
  };
  std::vector<Problem> problems_;
};

}  // namespace morphgrid
