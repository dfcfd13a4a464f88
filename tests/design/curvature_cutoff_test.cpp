#include "design/curvature_cutoff.h"

#include <gmock/gmock.h>

#include <cmath>

namespace morphgrid {
namespace {

/// Isolines of 20 and 10; |kappa| from 0 to 1 in steps of 0.001.
SurfaceSurvey evenSurvey() {
  SurfaceSurvey survey{20, 10, 1, 1, {}};
  for (int n = 0; n <= 1000; ++n) survey.sortedCurvatures.push_back(n / 1000.0);
  return survey;
}

DesignRequest request(double layerSpacing, int nodesLong) {
  return {.layers = 3, .layerSpacing = layerSpacing, .nodesLong = nodesLong, .maxShrinkage = 0.5};
}

std::vector<double> cutoffsOf(const std::vector<CutoffConsequence>& consequences) {
  std::vector<double> cutoffs;
  for (const CutoffConsequence& c : consequences) cutoffs.push_back(c.cutoff);
  return cutoffs;
}

TEST(ListCutoffConsequences, GivesEquations21And23) {
  const auto list = listCutoffConsequences(evenSurvey(), request(1, 1));
  EXPECT_THAT(cutoffsOf(list), testing::ElementsAre(0.5, 0.9, 0.95, 0.99, 1));
  for (const CutoffConsequence& c : list) {
    EXPECT_NEAR(c.curvatureLimit, c.cutoff, 1e-3);
    EXPECT_NEAR(c.layerSpacingLimit, 0.5 / (2 * c.curvatureLimit), 1e-12);  // R maxShrinkage / 2
    EXPECT_EQ(c.fewestNodes, std::ceil(20 * c.curvatureLimit / 2));
  }
}

TEST(ListCutoffConsequences, AgreesWithTheSizeThatIsChosen) {
  DesignRequest asked = request(1, 20);
  for (const CutoffConsequence& c : listCutoffConsequences(evenSurvey(), asked)) {
    asked.curvatureCutoff = c.cutoff;
    const GridSize size = chooseGridSize(evenSurvey(), asked);
    EXPECT_EQ(size.curvatureLimit, c.curvatureLimit);
    EXPECT_EQ(size.layerSpacingLimit, c.layerSpacingLimit);
    EXPECT_EQ(size.fewestNodes, c.fewestNodes);
  }
}

TEST(ListCutoffConsequences, WhatDoesNotBendHasNoLimits) {
  const SurfaceSurvey flat{20, 10, 0, 0, {0, 0, 0}};
  for (const CutoffConsequence& c : listCutoffConsequences(flat, request(1, 1))) {
    EXPECT_TRUE(std::isinf(c.layerSpacingLimit));
    EXPECT_EQ(c.fewestNodes, 1);
  }
  DesignRequest oneLayer = request(1, 1);
  oneLayer.layers = 1;
  EXPECT_TRUE(std::isinf(consequenceOf(1, evenSurvey(), oneLayer).layerSpacingLimit));
}

TEST(SuggestCutoff, KeepsAllOfWhatFits) {
  EXPECT_EQ(suggestCutoff(evenSurvey(), request(0.1, 20)), 1);
}

TEST(SuggestCutoff, IsTheLargestThatKeepsTheLayerSpacing) {
  // 0.25 / kappa >= 0.4 where kappa <= 0.625.
  EXPECT_EQ(suggestCutoff(evenSurvey(), request(0.4, 20)), 0.62);
}

TEST(SuggestCutoff, IsTheLargestThatKeepsTheNodes) {
  // 10 kappa <= 7 where kappa <= 0.7.
  EXPECT_EQ(suggestCutoff(evenSurvey(), request(0.1, 7)), 0.7);
}

TEST(SuggestCutoff, TheGridThenNeedsNoChange) {
  DesignRequest asked = request(0.7, 3);
  asked.curvatureCutoff = suggestCutoff(evenSurvey(), asked).value();
  const GridSize size = chooseGridSize(evenSurvey(), asked);
  EXPECT_EQ(size.layerSpacing, 0.7);
  EXPECT_EQ(size.nodesU, 3);
}

TEST(SuggestCutoff, NothingHelpsWhereAllIsCurvedAlike) {
  const SurfaceSurvey sphere{20, 10, 1, 1, std::vector<double>(1000, 1.0)};
  EXPECT_EQ(suggestCutoff(sphere, request(0.4, 20)), std::nullopt);
}

}  // namespace
}  // namespace morphgrid
