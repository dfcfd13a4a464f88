#include "report/report_json.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/report/sample_record.h"

namespace morphgrid {
namespace {

TEST(ReportJson, HoldsAllKeysAndRoundTrips) {
  const auto json = nlohmann::json::parse(toJson(sampleRecord()));
  for (const char* key :
       {"scene", "method", "scaling", "device", "seconds_total", "grid", "measurement", "in_plane",
        "full", "errors", "distance_to_target", "shrink", "feasibility"}) {
    EXPECT_TRUE(json.contains(key)) << key;
  }
  EXPECT_EQ(json["grid"]["nodes_u"], 17);
  EXPECT_EQ(json["grid"]["nodes_v"], 20);
  EXPECT_EQ(json["grid"]["vertices"], 1134);
  EXPECT_EQ(json["grid"]["layer_spacing"], 0.3);
  EXPECT_EQ(json["measurement"]["fewest_nodes"], 4);
  EXPECT_TRUE(json["measurement"]["layer_spacing_limit"].is_null());
  EXPECT_EQ(json["full"]["energy"].get<double>(), 0.1 + 0.2);
  EXPECT_EQ(json["full"]["reason"], "residual");
  EXPECT_EQ(json["full"]["converged"], true);
  EXPECT_EQ(json["distance_to_target"]["closest_point_max_percent"], 7);
  EXPECT_EQ(json["shrink"]["struts_over_limit"], 0);
}

TEST(ReportJson, GivesTheSmallestEigenvalueOnRequest) {
  RunRecord record = sampleRecord();
  auto json = nlohmann::json::parse(toJson(record));
  EXPECT_TRUE(json["in_plane"]["smallest_eigenvalue"].is_null());
  const auto eigenvalue = json["full"]["smallest_eigenvalue"];
  EXPECT_EQ(eigenvalue["value"], 2e-5);
  EXPECT_EQ(eigenvalue["residual"], 1e-6);
  EXPECT_EQ(eigenvalue["iterations"], 9);
  EXPECT_EQ(eigenvalue["converged"], true);
  EXPECT_EQ(eigenvalue["verdict"], "minimum");
  record.full->smallestEigenvalue->value = -2e-5;
  json = nlohmann::json::parse(toJson(record));
  EXPECT_EQ(json["full"]["smallest_eigenvalue"]["verdict"], "saddle");
  record.full->converged = false;
  json = nlohmann::json::parse(toJson(record));
  EXPECT_EQ(json["full"]["smallest_eigenvalue"]["verdict"], "undecided");
}

TEST(ReportJson, TellsHowDistancesAndShrinkAreSpread) {
  const auto json = nlohmann::json::parse(toJson(sampleRecord()));
  const auto& distance = json["distance_to_target"];
  EXPECT_EQ(distance["median_percent"], 3.5);
  EXPECT_EQ(distance["percentile_90_percent"], 4.5);
  EXPECT_EQ(distance["percentile_99_percent"], 4.75);
  EXPECT_EQ(distance["histogram"]["bin_percent"], 0.5);
  EXPECT_EQ(distance["histogram"]["counts"],
            nlohmann::json::parse("[2, 1, 0, 0, 0, 0, 0, 0, 0, 1]"));
  EXPECT_EQ(distance["closest_point_histogram"]["counts"].size(), 10u);
  EXPECT_EQ(json["shrink"]["struts_at_limit"], 2);
  EXPECT_EQ(json["shrink"]["struts_growing"], 0);
  EXPECT_EQ(json["shrink"]["layers"].size(), 2u);
  EXPECT_EQ(json["shrink"]["layers"][0]["largest_percent"], 31);
}

TEST(ReportJson, NamesThePlacesOfWhatIsWrong) {
  RunRecord record = sampleRecord();
  auto json = nlohmann::json::parse(toJson(record))["feasibility"];
  EXPECT_EQ(json["inverted_cells"], 0);
  EXPECT_EQ(json["self_intersecting_cells"], 0);
  EXPECT_TRUE(json["first_self_intersection"].is_null());
  EXPECT_TRUE(json["close_struts"].is_null()) << "not asked for";
  record.feasibility->cells = {3, 4, -0.5, {5, 6, 2}};
  record.feasibility->selfIntersection = {7, {8, 9, 1}};
  record.feasibility->closeStruts = CloseStruts{0.25, 0, 0.25, {}};
  json = nlohmann::json::parse(toJson(record))["feasibility"];
  EXPECT_EQ(json["collapsed_cells"], 4);
  EXPECT_EQ(json["smallest_relative_area"], -0.5);
  EXPECT_EQ(json["smallest_cell"], nlohmann::json::parse("[5, 6, 2]"));
  EXPECT_EQ(json["first_self_intersection"], nlohmann::json::parse("[8, 9, 1]"));
  EXPECT_EQ(json["close_struts"]["count"], 0);
  EXPECT_TRUE(json["close_struts"]["smallest_clearance"].is_null()) << "none is close";
  record.feasibility->closeStruts = CloseStruts{0.25, 2, 0.125, {1, 2, 0}};
  json = nlohmann::json::parse(toJson(record))["feasibility"];
  EXPECT_EQ(json["close_struts"]["smallest_clearance"], 0.125);
  EXPECT_EQ(json["close_struts"]["closest"], nlohmann::json::parse("[1, 2, 0]"));
}

TEST(ReportJson, ListsTheCutoffs) {
  const auto m = nlohmann::json::parse(toJson(sampleRecord()))["measurement"];
  ASSERT_EQ(m["cutoffs"].size(), 2u);
  EXPECT_TRUE(m["cutoffs"][0]["layer_spacing_limit"].is_null());
  EXPECT_EQ(m["cutoffs"][1]["p"], 0.95);
  EXPECT_EQ(m["cutoffs"][1]["curvature"], 0.4785);
  EXPECT_EQ(m["cutoffs"][1]["layer_spacing_limit"], 0.418);
  EXPECT_EQ(m["cutoffs"][1]["fewest_nodes"], 1e12);
  EXPECT_EQ(m["suggested_cutoff"], 0.93);
  EXPECT_EQ(m["curvature_noise"], 0.0625);
}

TEST(ReportJson, WhatARunDoesNotHaveIsNull) {
  RunRecord record = sampleRecord();
  record.measurement.reset();
  record.full.reset();
  record.distance.reset();
  const auto json = nlohmann::json::parse(toJson(record));
  EXPECT_TRUE(json["measurement"].is_null());
  EXPECT_TRUE(json["full"].is_null());
  EXPECT_TRUE(json["distance_to_target"].is_null());
}

TEST(ReportJson, TellsHowTheNetRuns) {
  RunRecord record = sampleRecord();
  EXPECT_TRUE(nlohmann::json::parse(toJson(record))["net"].is_null());
  const double pi = std::acos(-1.0);
  record.net = NetFigures{NetKind::orthogonal, 1.25, 0.5, {3.5, pi / 180, pi / 6}};
  const auto net = nlohmann::json::parse(toJson(record))["net"];
  EXPECT_EQ(net["kind"], "orthogonal");
  EXPECT_EQ(net["modulus"], 1.25);
  EXPECT_EQ(net["blend"], 0.5);
  EXPECT_EQ(net["strut_ratio"], 3.5);
  EXPECT_NEAR(net["mean_angle_deviation_degrees"].get<double>(), 1, 1e-14);
  EXPECT_NEAR(net["largest_angle_deviation_degrees"].get<double>(), 30, 1e-13);
  record.net->modulus.reset();
  EXPECT_TRUE(nlohmann::json::parse(toJson(record))["net"]["modulus"].is_null());
}

TEST(ReportJson, WithoutAdviceItIsNull) {
  RunRecord record = sampleRecord();
  record.measurement->suggestedCutoff.reset();
  record.measurement->curvatureNoise.reset();
  const auto json = nlohmann::json::parse(toJson(record));
  EXPECT_TRUE(json["measurement"]["suggested_cutoff"].is_null());
  EXPECT_TRUE(json["measurement"]["curvature_noise"].is_null());
}

}  // namespace
}  // namespace morphgrid
