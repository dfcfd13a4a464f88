#pragma once
#include <functional>
#include <mutex>

#include "view/session.h"

namespace morphgrid {

/// The newest snapshot, changed by some threads, seen by others.
class SnapshotBoard {
 public:
  /// wake: called after every change.
  explicit SnapshotBoard(std::function<void()> wake) : wake_(std::move(wake)) {}

  std::shared_ptr<const Snapshot> newest() const {
    const std::lock_guard lock(mutex_);
    return newest_;
  }

  /// Posts a copy of the newest with a change(Snapshot&).
  template <typename Change>
  void post(const Change& change) {
    {
      const std::lock_guard lock(mutex_);
      auto next = std::make_shared<Snapshot>(*newest_);
      change(*next);
      newest_ = std::move(next);
    }
    wake_();
  }

 private:
  std::function<void()> wake_;
  mutable std::mutex mutex_;
  std::shared_ptr<const Snapshot> newest_ = std::make_shared<Snapshot>();
};

}  // namespace morphgrid
