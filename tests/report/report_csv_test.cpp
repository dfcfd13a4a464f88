#include "report/report_csv.h"

#include <gtest/gtest.h>

#include "tests/report/sample_record.h"

namespace morphgrid {
namespace {

TEST(ConvergenceCsv, HasALinePerSample) {
  EXPECT_EQ(toConvergenceCsv(sampleRecord()),
            "stage,iteration,energy,residual,seconds,grid_share\n"
            "in_plane,16,2.5,0.001,0.25,1\n"
            "in_plane,32,0.30000000000000004,1e-10,0.5,1\n"
            "full,16,2.5,0.001,0.25,1\n"
            "full,32,0.30000000000000004,1e-10,0.5,1\n");
}

}  // namespace
}  // namespace morphgrid
