#include "benchmark/child_process.h"

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace morphgrid {
namespace {

ProcessCost costOf(const std::string& script) {
  const TemporaryFolder folder;
  ChildProcess child("/bin/sh", {"-c", script}, folder / "output");
  EXPECT_EQ(child.exitCode(), 0) << child.output();
  return child.cost();
}

TEST(ChildProcess, CostIsThatOfTheProcessAndOfWhatItBecomes) {
  const double nothing = costOf("true").cpuSeconds;
  const double counted =
      costOf("exec /bin/sh -c 'n=0; while [ $n -lt 300000 ]; do n=$((n+1)); done'").cpuSeconds;
  EXPECT_GT(counted, nothing + 0.02);
}

TEST(ChildProcess, PeakIsWhatWasHeldAtOnce) {
  // dd fills one block of its size.
  const auto peakOf = [](const char* size) {
    return costOf(std::string("exec dd if=/dev/zero of=/dev/null count=1 bs=") + size)
        .peakMegabytes;
  };
  EXPECT_NEAR(peakOf("400M") - peakOf("200M"), 210, 30);
}

}  // namespace
}  // namespace morphgrid
