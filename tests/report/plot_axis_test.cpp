#include "report/plot_axis.h"

#include <gmock/gmock.h>

#include <limits>

namespace morphgrid {
namespace {

using testing::ElementsAre;
using testing::Pointwise;

TEST(PlotAxis, LinearOnesHaveRoundSteps) {
  EXPECT_THAT(PlotAxis(PlotScale::linear, {0, 42, 17}).ticks(), ElementsAre(0, 10, 20, 30, 40, 50));
  EXPECT_THAT(PlotAxis(PlotScale::linear, {-1, 2}).ticks(),
              Pointwise(testing::DoubleEq(), std::vector<double>{-1, -0.5, 0, 0.5, 1, 1.5, 2}));
  EXPECT_THAT(PlotAxis(PlotScale::linear, {33, 35.5}).ticks(),
              Pointwise(testing::DoubleEq(), std::vector<double>{33, 33.5, 34, 34.5, 35, 35.5}));
}

TEST(PlotAxis, RoundingErrorsAreNoRange) {
  EXPECT_THAT(PlotAxis(PlotScale::linear, {60, 60.00000000000001}).ticks(), ElementsAre(60, 80));
  EXPECT_THAT(PlotAxis(PlotScale::linear, {5e-324, 0}).ticks(), testing::SizeIs(2));
}

TEST(PlotAxis, LogarithmicOnesHaveWholeDecades) {
  EXPECT_THAT(PlotAxis(PlotScale::logarithmic, {0.02, 5}).ticks(),
              Pointwise(testing::DoubleEq(), std::vector<double>{0.01, 0.1, 1, 10}));
  EXPECT_THAT(PlotAxis(PlotScale::logarithmic, {100}).ticks(), ElementsAre(100, 1000));
}

TEST(PlotAxis, SharesRunFromTheFirstToTheLastTick) {
  const PlotAxis linear(PlotScale::linear, {0, 50});
  EXPECT_DOUBLE_EQ(linear.share(0), 0);
  EXPECT_DOUBLE_EQ(linear.share(20), 0.4);
  EXPECT_DOUBLE_EQ(linear.share(50), 1);
  EXPECT_DOUBLE_EQ(PlotAxis(PlotScale::logarithmic, {1, 10000}).share(100), 0.5);
}

TEST(PlotAxis, AreThereForAnyValues) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  for (const PlotScale scale : {PlotScale::linear, PlotScale::logarithmic}) {
    for (const std::vector<double>& values : {std::vector<double>{},
                                              {0},
                                              {-5},
                                              {3, 3},
                                              {kNan, kInfinity},
                                              {-1e300, 1e300},
                                              {1e-300, 1e300},
                                              {1e308, -1e308},
                                              {5e-324, 0}}) {
      const PlotAxis axis(scale, values);
      ASSERT_GE(axis.ticks().size(), 2u);
      EXPECT_EQ(axis.share(axis.ticks().front()), 0);
      EXPECT_EQ(axis.share(axis.ticks().back()), 1);
    }
  }
}

}  // namespace
}  // namespace morphgrid
