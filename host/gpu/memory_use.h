#pragma once
#include <algorithm>
#include <cstdint>
#include <memory>

namespace morphgrid {

/// How many bytes are held now, and at most at a time.
class MemoryUse {
 public:
  /// Counts them for as long as the result lives. *this must outlive it.
  std::shared_ptr<const void> hold(std::uint64_t bytes) {
    current_ += bytes;
    peak_ = std::max(peak_, current_);
    return {this, [bytes](MemoryUse* use) { use->current_ -= bytes; }};
  }

  std::uint64_t current() const { return current_; }
  std::uint64_t peak() const { return peak_; }
  void forgetPeak() { peak_ = current_; }

 private:
  std::uint64_t current_ = 0;
  std::uint64_t peak_ = 0;
};

}  // namespace morphgrid
