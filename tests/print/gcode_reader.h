#pragma once
#include <Eigen/Core>
#include <map>
#include <string>
#include <vector>

namespace morphgrid {

/// A straight piece that is laid, or a travel. mm.
struct GcodeMove {
  Eigen::Vector2d from, to;
  double z;
  double filament;   ///< 0 of travels.
  double speed;      ///< mm/s
  bool isDrawnBack;  ///< The filament, before it.
  std::string name;  ///< The last comment that names something, "strut u 0 0 along".
  std::string type;  ///< After ";TYPE:".

  double length() const { return (to - from).norm(); }
};

/// What a printer would do, as a reader of its own sees it: it knows nothing of the writer.
struct ReadGcode {
  std::vector<GcodeMove> laid, travels;
  std::vector<double> passHeights;  ///< After ";Z:".
  std::vector<int> progress;        ///< Of M73.
  double filament = 0;              ///< All of it, what is drawn back and pushed again included.
  std::map<std::string, double> totals;  ///< "; NAME = VALUE" at the end.
  int lifts = 0;                         ///< Moves along z.
};

/// Throws std::runtime_error when there is a command that it does not know.
ReadGcode readGcode(const std::string& text);

}  // namespace morphgrid
