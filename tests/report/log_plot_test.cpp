#include "report/plot.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <regex>

namespace morphgrid {
namespace {

struct Mark {
  double x;
  double y;
  std::string fill;
};

/// What the pattern captures, once a match.
std::vector<std::smatch> matchesOf(const std::string& text, const char* pattern) {
  const std::regex regex(pattern);
  return {std::sregex_iterator(text.begin(), text.end(), regex), std::sregex_iterator()};
}

std::vector<Mark> marksOf(const std::string& svg) {
  std::vector<Mark> marks;
  for (const std::smatch& match :
       matchesOf(svg, "<circle cx=\"([^\"]*)\" cy=\"([^\"]*)\"[^>]* fill=\"([^\"]*)\"")) {
    marks.push_back({std::stod(match[1]), std::stod(match[2]), match[3]});
  }
  return marks;
}

/// Both axes are logarithmic.
std::string svgOf(std::vector<PlotSeries> series) {
  return toSvg(
      {"title", "x", PlotScale::logarithmic, {{"y", PlotScale::logarithmic, std::move(series)}}});
}

std::vector<Mark> marksAt(const std::vector<PlotPoint>& points) {
  return marksOf(svgOf({{"series", points}}));
}

constexpr double kPixel = 0.11;  // Pixels have one decimal.

TEST(LogPlotTest, EqualRatiosAreEqualDistances) {
  const auto marks = marksAt({{2, 30, false}, {20, 3, false}, {200, 0.3, false}});
  ASSERT_EQ(marks.size(), 3U);
  EXPECT_GT(marks[1].x - marks[0].x, 50);
  EXPECT_GT(marks[1].y - marks[0].y, 50) << "less is further down";
  EXPECT_NEAR(marks[2].x - marks[1].x, marks[1].x - marks[0].x, kPixel);
  EXPECT_NEAR(marks[2].y - marks[1].y, marks[1].y - marks[0].y, kPixel);
}

TEST(LogPlotTest, OtherUnitsOfAPowerOfTenMoveNothing) {
  const auto marks = marksAt({{2, 5, false}, {700, 40, false}});
  const auto scaled = marksAt({{2000, 5e-4, false}, {700000, 4e-3, false}});
  for (std::size_t n = 0; n < marks.size(); ++n) {
    EXPECT_NEAR(scaled[n].x, marks[n].x, kPixel);
    EXPECT_NEAR(scaled[n].y, marks[n].y, kPixel);
  }
}

TEST(LogPlotTest, MarksStandAboveTheLabelsOfTheirDecades) {
  const std::string svg = svgOf({{"series", {{100, 10, false}, {10000, 1000, false}}}});
  const auto marks = marksOf(svg);
  const auto labels = matchesOf(svg, "<text x=\"([^\"]*)\"[^>]*>(100|10000)</text>");
  ASSERT_EQ(labels.size(), 3U) << "100 stands on both axes";
  EXPECT_NEAR(std::stod(labels[0][1]), marks[0].x, kPixel);
  EXPECT_NEAR(std::stod(labels[1][1]), marks[1].x, kPixel);
}

TEST(LogPlotTest, OnePointOnADecadeHasAxesAllTheSame) {
  const auto marks = marksAt({{1000, 1, false}});
  ASSERT_EQ(marks.size(), 1U);
  EXPECT_TRUE(std::isfinite(marks[0].x) && std::isfinite(marks[0].y));
}

TEST(LogPlotTest, PointsAreJoinedInTheOrderOfX) {
  const auto marks = marksAt({{200, 1, false}, {2, 3, false}, {20, 2, false}});
  EXPECT_LT(marks[0].x, marks[1].x);
  EXPECT_LT(marks[1].x, marks[2].x);
}

TEST(LogPlotTest, BoundsAreHollowWithAnArrowUpwards) {
  const std::vector<PlotPoint> known{{1, 1, false}, {10, 2, false}};
  std::vector<PlotPoint> bounded = known;
  bounded[1].atLeast = true;
  const std::string svg = svgOf({{"series", bounded}});
  const auto marks = marksOf(svg);
  EXPECT_NE(marks[0].fill, "white");
  EXPECT_EQ(marks[1].fill, "white");
  const auto linesOf = [](const std::string& text) { return matchesOf(text, "<line").size(); };
  EXPECT_EQ(linesOf(svg), linesOf(svgOf({{"series", known}})) + 3);
}

TEST(LogPlotTest, NamesDoNotCoverEachOther) {
  const std::string svg = svgOf(
      {{"first", {{10, 5, false}}}, {"second", {{10, 5, false}}}, {"third", {{10, 5.1, false}}}});
  std::vector<double> lines;
  for (const std::smatch& match : matchesOf(svg, "y=\"([^\"]*)\"[^>]*>(first|second|third)<")) {
    lines.push_back(std::stod(match[1]));
  }
  ASSERT_EQ(lines.size(), 3U);
  std::sort(lines.begin(), lines.end());
  EXPECT_GE(lines[1] - lines[0], 16 - kPixel);
  EXPECT_GE(lines[2] - lines[1], 16 - kPixel);
}

}  // namespace
}  // namespace morphgrid
