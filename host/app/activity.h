#pragma once
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace morphgrid {

/// While it lives, says on stderr what the program is doing, if that takes more than a second: for
/// work that cannot tell how far it is.
class Activity {
 public:
  /// what: "measuring the target".
  Activity(std::string what, bool quiet);
  ~Activity();
  Activity(const Activity&) = delete;
  Activity& operator=(const Activity&) = delete;

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
