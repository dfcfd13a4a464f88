#pragma once
#include <optional>
#include <string>
#include <vector>

namespace morphgrid {

/// What keeps a grid from being printed, or a result from being of use.
struct Obstacle {
  std::string what;    ///< With counts.
  std::string wayOut;  ///< What to do about it; may be empty.

  bool operator==(const Obstacle&) const = default;
};

/// Whether a result can be printed; of what cannot be, such as a single layer, whether it is of
/// use.
struct PrintVerdict {
  bool isOfPrint = true;
  std::vector<Obstacle> obstacles;
  std::string reservation;  ///< What could not be judged; may be empty.

  bool isGood() const { return obstacles.empty(); }
  /// "printable: yes", "printable: no, because ..." or "result: useless, because ...", with ways
  /// out; empty where nothing is printed and all is well.
  std::string line() const;
};

/// What a design knew of its print: on that depends what helps where struts are out of range.
struct DesignBounds {
  bool hasPrint = false;    ///< There is a [print].
  bool isEnforced = false;  ///< design.enforce_shrinkage
  /// What designs anew for what is printed with, a command; empty where the design did know it.
  std::string anew = {};
};

struct PrintPlan;

/// Struts that the material cannot make as short, or as long, as the design wants.
std::optional<Obstacle> strutsOutOfRange(const PrintPlan& plan, const DesignBounds& design);

}  // namespace morphgrid
