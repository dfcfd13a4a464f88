#pragma once
#include <memory>
#include <string>

namespace morphgrid {

/// While it lives, says on stderr what the program is doing, if that takes more than a second: for
/// work that cannot tell how far it is.
class ActivityLine {
 public:
  /// what: "measuring the target".
  ActivityLine(std::string what, bool quiet);
  ~ActivityLine();
  ActivityLine(const ActivityLine&) = delete;
  ActivityLine& operator=(const ActivityLine&) = delete;

 private:
  struct State;

  static void watch(State& state);

  std::shared_ptr<State> state_;  ///< Shared with the thread that watches.
};

}  // namespace morphgrid
