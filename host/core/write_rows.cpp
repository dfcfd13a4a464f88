#include "core/write_rows.h"

#include <algorithm>
#include <vector>

#include "core/parallel_for.h"

namespace morphgrid {
namespace {

constexpr std::ptrdiff_t kRowsPerBlock = 4096;
constexpr std::ptrdiff_t kMostBlocks = 32;  // In memory at a time.

}  // namespace

void writeRows(std::ostream& stream, std::ptrdiff_t count,
               const std::function<void(std::string& bytes, std::ptrdiff_t row)>& append) {
  std::vector<std::string> blocks(
      static_cast<std::size_t>(std::min(kMostBlocks, (count + kRowsPerBlock - 1) / kRowsPerBlock)));
  for (std::ptrdiff_t begin = 0; begin < count && stream; begin += kMostBlocks * kRowsPerBlock) {
    for (std::string& block : blocks) block.clear();
    parallelRanges(std::min(count - begin, kMostBlocks * kRowsPerBlock), kRowsPerBlock,
                   [&](std::ptrdiff_t first, std::ptrdiff_t last) {
                     std::string& block = blocks[static_cast<std::size_t>(first / kRowsPerBlock)];
                     for (std::ptrdiff_t n = first; n < last; ++n) append(block, begin + n);
                   });
    for (const std::string& block : blocks) {
      stream.write(block.data(), static_cast<std::streamsize>(block.size()));
    }
  }
}

}  // namespace morphgrid
