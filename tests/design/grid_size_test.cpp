#include "design/grid_size.h"

#include <gmock/gmock.h>

#include <cmath>
#include <string>

#include "core/error.h"

namespace morphgrid {
namespace {

using testing::HasSubstr;

SurfaceSurvey survey(double lengthU, double lengthV, double curvature) {
  return {lengthU, lengthV, curvature, 0, {0, curvature / 2, curvature}};
}

TEST(ChooseGridSize, GivesTheLongerDirectionTheNodes) {
  const DesignRequest request{.layers = 3, .layerSpacing = 0.1, .nodesLong = 30};
  const GridSize wide = chooseGridSize(survey(867.4, 735.1, 0), request);
  EXPECT_EQ(wide.nodesU, 30);
  EXPECT_EQ(wide.nodesV, 26);
  const GridSize tall = chooseGridSize(survey(10, 20, 0), request);
  EXPECT_EQ(tall.nodesU, 15);
  EXPECT_EQ(tall.nodesV, 30);
}

TEST(ChooseGridSize, FlatSurfacesHaveNoLimits) {
  const DesignRequest request{.layers = 3, .layerSpacing = 1e6, .nodesLong = 1};
  const GridSize size = chooseGridSize(survey(2, 1, 0), request);
  EXPECT_EQ(size.layerSpacing, 1e6);
  EXPECT_TRUE(std::isinf(size.layerSpacingLimit));
  EXPECT_EQ(size.fewestNodes, 1);
  EXPECT_EQ(size.nodesU, 1);
  EXPECT_EQ(size.nodesV, 1);
  EXPECT_TRUE(size.notices.empty());
}

TEST(ChooseGridSize, ClampsTheLayerSpacingAndSaysSo) {
  const DesignRequest request{
      .layers = 3, .layerSpacing = 0.6, .nodesLong = 10, .maxShrinkage = 0.4};
  const GridSize size = chooseGridSize(survey(2, 1, 0.5), request);
  EXPECT_NEAR(size.layerSpacingLimit, 2 * 0.4 / 2, 1e-15);  // R maxShrinkage / (layers - 1)
  EXPECT_EQ(size.layerSpacing, size.layerSpacingLimit);
  ASSERT_EQ(size.notices.size(), 1u);
  EXPECT_THAT(size.notices[0], HasSubstr("Eq. 21"));
  EXPECT_THAT(size.notices[0],
              HasSubstr("grid.curvature_cutoff = 0.99 would do, capping curvature to 0.25"));
}

TEST(ChooseGridSize, RaisesTooFewNodesAndSaysSo) {
  const DesignRequest request{.layers = 1, .layerSpacing = 1, .nodesLong = 5};
  const GridSize size = chooseGridSize(survey(20, 10, 0.9), request);
  EXPECT_EQ(size.fewestNodes, 9);  // 20 / (2 / 0.9)
  EXPECT_EQ(size.nodesU, 9);
  EXPECT_EQ(size.nodesV, 5);
  ASSERT_EQ(size.notices.size(), 1u);
  EXPECT_THAT(size.notices[0], HasSubstr("Eq. 23"));
  EXPECT_THAT(size.notices[0], HasSubstr("grid.curvature_cutoff = 0.99 would do"));
}

TEST(ChooseGridSize, SaysWhereNoCutoffWouldDo) {
  const SurfaceSurvey sphere{2, 1, 0.5, 0.5, {0.5, 0.5, 0.5}};
  const GridSize size = chooseGridSize(sphere, {.layerSpacing = 1, .nodesLong = 10});
  ASSERT_EQ(size.notices.size(), 1u);
  EXPECT_THAT(size.notices[0], HasSubstr("no grid.curvature_cutoff of 0.5 or more would do"));
}

TEST(ChooseGridSize, DoesNotAdviseToCapMostOfTheSurface) {
  // Of {0, 0.5, 1} only the first would do.
  const GridSize size = chooseGridSize(survey(2, 1, 1), {.layerSpacing = 1, .nodesLong = 10});
  ASSERT_EQ(size.notices.size(), 1u);
  EXPECT_THAT(size.notices[0], HasSubstr("no grid.curvature_cutoff of 0.5 or more would do"));
}

TEST(ChooseGridSize, CutoffLowersTheCurvatureAndSaysSo) {
  const DesignRequest request{
      .layers = 2, .layerSpacing = 0.01, .nodesLong = 10, .curvatureCutoff = 0.5};
  const GridSize size = chooseGridSize(survey(2, 1, 1), request);
  EXPECT_EQ(size.curvatureLimit, 0.5);
  EXPECT_THAT(size.notices, testing::ElementsAre(HasSubstr("cutoff")));
}

std::string refusalOf(const SurfaceSurvey& survey, const DesignRequest& request) {
  try {
    chooseGridSize(survey, request);
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(ChooseGridSize, RaisesNodesFourTimesButNoFurther) {
  // 20 / (2 / 0.8) = 8
  EXPECT_EQ(chooseGridSize(survey(20, 10, 0.8), {.layerSpacing = 0.1, .nodesLong = 2}).nodesU, 8);
  const std::string refusal = refusalOf(survey(20, 10, 0.9), {.layerSpacing = 0.1, .nodesLong = 2});
  EXPECT_THAT(refusal, HasSubstr("needs at least 9 nodes"));
  EXPECT_THAT(refusal, HasSubstr("4.5 times grid.nodes_long = 2; it is raised to 8 at most"));
  EXPECT_THAT(refusal, HasSubstr("set grid.nodes_long = 9 if"));
}

TEST(ChooseGridSize, AKinkIsRefusedWithTheCutoffThatLeavesItOut) {
  SurfaceSurvey kinked = survey(20, 10, 0);
  kinked.sortedCurvatures.assign(1000, 0.1);
  kinked.sortedCurvatures.insert(kinked.sortedCurvatures.end(), 50, 58.0);
  const DesignRequest request{.layerSpacing = 0.1, .nodesLong = 4};
  EXPECT_THAT(refusalOf(kinked, request),
              HasSubstr("grid.curvature_cutoff = 0.95 keeps those that you asked for"));
  DesignRequest advised = request;
  advised.curvatureCutoff = 0.95;
  EXPECT_EQ(chooseGridSize(kinked, advised).nodesU, 4);
}

TEST(ChooseGridSize, AskingForTheNodesAllowsThem) {
  const GridSize size = chooseGridSize(survey(20, 10, 58), {.layerSpacing = 0.1, .nodesLong = 580});
  EXPECT_EQ(size.nodesU, 580);
}

TEST(ChooseGridSize, RefusesCurvatureThatAsksForThousandsOfNodes) {
  EXPECT_THAT(refusalOf(survey(1, 1, 1e4), {.layerSpacing = 1, .nodesLong = 1900}),
              HasSubstr("raised to 2000 at most: set grid.nodes_long = 5000 if"));
}

TEST(ChooseGridSize, AModulusSetsTheRatioOfTheNodes) {
  const DesignRequest request{.layers = 3, .layerSpacing = 0.1, .nodesLong = 30};
  const GridSize wide = chooseGridSize(survey(10, 20, 0), request, 0.6996);
  EXPECT_EQ(wide.nodesU, 30);
  EXPECT_EQ(wide.nodesV, 21);
  const GridSize tall = chooseGridSize(survey(10, 20, 0), request, 1.2471);
  EXPECT_EQ(tall.nodesU, 24);
  EXPECT_EQ(tall.nodesV, 30);
  EXPECT_EQ(chooseGridSize(survey(10, 20, 0), request, 1e3).nodesU, 1);
}

}  // namespace
}  // namespace morphgrid
