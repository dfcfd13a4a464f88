#include "print/assembly_page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "print/assess_print.h"
#include "tests/print/print_samples.h"

namespace morphgrid {
namespace {

using testing::HasSubstr;

int countOf(const std::string& text, const std::string& what) {
  int count = 0;
  for (auto at = text.find(what); at != text.npos; at = text.find(what, at + 1)) ++count;
  return count;
}

PrintRecord sampleRecord() {
  StrutGrid grid = flatGrid({4, 3, 2}, 0.2);
  grid.rest.u[0] = 0.3;  // Out of range.
  PrintRecord record{.plan = planPrint("a <grid> & more", grid, samplePrinter(), sampleMaterial(),
                                       {.scale = 20, .enlargement = 1.0})};
  for (int tier = 0; tier < 2; ++tier) {
    record.tiers.push_back(writeTier(record.plan, tier, true).figures);
  }
  record.verdict.obstacles = {*strutsOutOfRange(record.plan, {})};
  return record;
}

TEST(TierMap, IsAtOneToOne) {
  const PrintPlan plan = sampleRecord().plan;
  const std::string map = tierMap(plan, 0);
  const double around = plan.hub.diameter + 24;
  const auto width =
      static_cast<int>(std::abs(plan.positions(0, 3) - plan.positions(0, 0)) + around);
  EXPECT_THAT(map, HasSubstr("mm\" height=\""));
  EXPECT_THAT(map, HasSubstr("width=\"" + std::to_string(width)));
  EXPECT_EQ(countOf(map, "<line"), 17 + 1);  // Struts and the ruler.
  EXPECT_EQ(countOf(map, "<circle"), 12 + 1);
  EXPECT_EQ(countOf(map, "dasharray"), 1);
  EXPECT_EQ(countOf(tierMap(plan, 1), "dasharray"), 0);
}

TEST(AssemblyPage, SaysWhatToDo) {
  const std::string page = assemblyPage(sampleRecord());
  EXPECT_THAT(page, HasSubstr("<h1>a &lt;grid&gt; &amp; more</h1>"));
  EXPECT_THAT(page, HasSubstr("Cut 12 pins of 1.75 mm"));
  EXPECT_THAT(page, HasSubstr("One laboratory, one filament, one printer"));
  EXPECT_THAT(page, HasSubstr("printable: no, because 1 of 34 struts"));
  EXPECT_THAT(page, HasSubstr("water of 80 degrees C"));
  EXPECT_EQ(countOf(page, "<figure>"), 2);
}

TEST(PrintReport, HasCountsAndWaysOut) {
  const PrintRecord record = sampleRecord();
  EXPECT_THAT(printTable(record), HasSubstr("strut u 0 0 of tier 1: 70.0 %, can "));
  EXPECT_THAT(record.verdict.line(),
              HasSubstr("1 would have to shrink more than they can, 0 less"));
  EXPECT_THAT(record.verdict.line(), HasSubstr("grid.max_shrinkage = 0.35"));
  EXPECT_THAT(printJson(record), HasSubstr("\"too_much\": 1"));
  EXPECT_THAT(printNotices(record).front(), HasSubstr("was not measured"));
}

}  // namespace
}  // namespace morphgrid
