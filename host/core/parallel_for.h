#pragma once
#include <cstddef>
#include <functional>

namespace morphgrid {

/// Calls work(first, last) of consecutive ranges of up to `grain` numbers that together are 0, ...,
/// count - 1: on all cores, in any order, so that each call may write only what is its own. Which
/// ranges there are depends on no machine. Where some throw, the exception of the first range is
/// thrown, as a loop would; after Cancelled no further range is begun. A single range is done by
/// the caller's thread. grain >= 1.
void parallelRanges(std::ptrdiff_t count, std::ptrdiff_t grain,
                    const std::function<void(std::ptrdiff_t first, std::ptrdiff_t last)>& work);

/// The same, number by number: work(n).
template <typename Work>
void parallelFor(std::ptrdiff_t count, std::ptrdiff_t grain, const Work& work) {
  parallelRanges(count, grain, [&](std::ptrdiff_t first, std::ptrdiff_t last) {
    for (std::ptrdiff_t n = first; n < last; ++n) work(n);
  });
}

}  // namespace morphgrid
