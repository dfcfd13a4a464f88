#include "report/plot.h"

#include <gmock/gmock.h>

#include <limits>

#include "report/inverse_plot.h"

namespace morphgrid {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

std::size_t countOf(const std::string& what, const std::string& text) {
  std::size_t count = 0;
  for (auto at = text.find(what); at != text.npos; at = text.find(what, at + 1)) ++count;
  return count;
}

Plot withPoints(std::vector<PlotPoint> points, PlotScale yScale = PlotScale::logarithmic) {
  return {
      "Title", "x axis", PlotScale::linear, {{"y axis", yScale, {{"name", std::move(points)}}}}};
}

TEST(Plot, SaysWhatItShows) {
  const std::string svg = toSvg(withPoints({{0, 0.02}, {42, 5}}));
  for (const char* text : {">Title<", ">x axis<", ">y axis<", ">name<", ">0.01<", ">10<", ">50<"}) {
    EXPECT_THAT(svg, HasSubstr(text));
  }
}

TEST(Plot, PutsPointsWhereTheAxesSay) {
  // The axes run from 0 to 10 over x = 80 to 610, from 1 to 100 over y = 420 to 40.
  const std::string svg = toSvg(withPoints({{0, 1}, {5, 10}, {10, 100}}));
  for (const char* place :
       {R"(cx="80.0" cy="420.0")", R"(cx="345.0" cy="230.0")", R"(cx="610.0" cy="40.0")"}) {
    EXPECT_THAT(svg, HasSubstr(place));
  }
}

TEST(Plot, LeavesOutWhatHasNoPlace) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<PlotPoint> points{{0, 1}, {1, 0}, {2, -1}, {3, nan}, {4, 10}};
  const std::string logarithmic = toSvg(withPoints(points));
  EXPECT_EQ(countOf("<circle", logarithmic), 2u);
  EXPECT_THAT(logarithmic, AllOf(Not(HasSubstr("nan")), Not(HasSubstr("inf"))));
  EXPECT_EQ(countOf("<circle", toSvg(withPoints(points, PlotScale::linear))), 4u);
  EXPECT_EQ(countOf("<circle", toSvg(withPoints({}))), 0u);
}

TEST(Plot, PanelsShareTheirXAxis) {
  Plot plot = withPoints({{0, 1}, {10, 100}});
  plot.panels.push_back({"other", PlotScale::linear, {{"second", {{100, 0}}}}});
  const std::string svg = toSvg(plot);
  EXPECT_EQ(countOf(">100<", svg), 2u);  // Once below the second panel, once beside the first.
  EXPECT_THAT(svg, HasSubstr(R"(cx="610.0" cy="464.0")"));
}

TEST(InversePlot, ShowsEveryStepAndTheLimit) {
  InverseDesign inverse;
  inverse.steps = {{InverseStep::Kind::design, 0, 1, 4, 20},
                   {InverseStep::Kind::optimise, 1, 0.5, 1, 25}};
  const std::string svg = toInversePlot(inverse, 0.4);
  EXPECT_EQ(countOf("<circle", svg), 8u);
  for (const char* name : {">RMS<", ">max<", ">asked for<", ">allowed<"}) {
    EXPECT_THAT(svg, HasSubstr(name));
  }
}

}  // namespace
}  // namespace morphgrid
