#pragma once
#include <atomic>
#include <cstdint>
#include <memory>

namespace morphgrid {

/// How many bytes are held now, and at most at a time, by all threads.
class MemoryUse {
 public:
  /// Counts them for as long as the result lives. *this must outlive it.
  std::shared_ptr<const void> hold(std::uint64_t bytes) {
    const std::uint64_t current = current_ += bytes;
    for (std::uint64_t peak = peak_;
         peak < current && !peak_.compare_exchange_weak(peak, current);) {
    }
    return {this, [bytes](MemoryUse* use) { use->current_ -= bytes; }};
  }

  std::uint64_t current() const { return current_; }
  std::uint64_t peak() const { return peak_; }
  void forgetPeak() { peak_ = current(); }

 private:
  std::atomic<std::uint64_t> current_ = 0;
  std::atomic<std::uint64_t> peak_ = 0;
};

}  // namespace morphgrid
