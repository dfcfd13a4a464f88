#include "core/parallel_for.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cassert>
#include <exception>
#include <limits>
#include <mutex>

#include "core/cancellation.h"

namespace morphgrid {
namespace {

constexpr std::ptrdiff_t kBeforeAll = -1;

/// Keeps the exception of the first range that threw.
class FirstFailure {
 public:
  /// Whether a range before this one has failed: then nobody asks for this one.
  bool isBefore(std::ptrdiff_t range) const { return range_ < range; }

  void add(std::ptrdiff_t range) {
    const std::lock_guard lock(adding_);
    if (isBefore(range)) return;
    range_ = range;
    exception_ = std::current_exception();
  }

  void rethrow() const {
    if (exception_) std::rethrow_exception(exception_);
  }

 private:
  std::mutex adding_;
  std::atomic<std::ptrdiff_t> range_ = std::numeric_limits<std::ptrdiff_t>::max();
  std::exception_ptr exception_;
};

}  // namespace

void parallelRanges(std::ptrdiff_t count, std::ptrdiff_t grain,
                    const std::function<void(std::ptrdiff_t first, std::ptrdiff_t last)>& work) {
  assert(grain >= 1);
  if (count <= grain) {
    if (count > 0) work(0, count);
    return;
  }
  FirstFailure failure;
  tbb::parallel_for(std::ptrdiff_t{0}, (count + grain - 1) / grain, [&](std::ptrdiff_t range) {
    if (failure.isBefore(range)) return;
    try {
      work(range * grain, std::min(count, (range + 1) * grain));
    } catch (const Cancelled&) {
      failure.add(kBeforeAll);  // No range need be asked any more.
    } catch (...) {
      failure.add(range);
    }
  });
  failure.rethrow();
}

}  // namespace morphgrid
