#pragma once
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

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
  void watch();

  std::string what_;
  bool onTerminal_;
  std::mutex mutex_;
  std::condition_variable ended_;
  bool hasEnded_ = false;
  std::thread watcher_;  ///< Last: it uses all of the above.
};

}  // namespace morphgrid
