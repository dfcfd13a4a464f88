// What helps where struts are out of range depends on what the design knew.
#include "print/print_verdict.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "print/assess_print.h"
#include "tests/print/print_samples.h"

namespace morphgrid {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

std::string wayOut(const DesignBounds& design) {
  const PrintPlan plan = planPrint("sample", flatGrid({6, 5, 2}, 0.6), samplePrinter(),
                                   sampleMaterial(), {.enlargement = 1});
  return strutsOutOfRange(plan, design).value().wayOut;
}

TEST(StrutsOutOfRange, ADesignThatDoesNotKnowIsToldHow) {
  EXPECT_THAT(wayOut({}), AllOf(HasSubstr("a [print] section and design.enforce_shrinkage"),
                                HasSubstr("grid.max_shrinkage = 0.")));
  EXPECT_THAT(wayOut({.hasPrint = true}),
              AllOf(HasSubstr("design.enforce_shrinkage in the scene"), Not(HasSubstr("[print]"))));
}

TEST(StrutsOutOfRange, OneThatKnowsIsNotToldAgain) {
  const auto isSilent = AllOf(Not(HasSubstr("enforce_shrinkage")), Not(HasSubstr("[print]")));
  EXPECT_THAT(wayOut({.hasPrint = true, .isEnforced = true}),
              AllOf(StartsWith("fewer and longer struts"), isSilent));
  EXPECT_THAT(wayOut({.hasPrint = true, .isEnforced = true, .anew = "morphgrid run s.toml"}),
              AllOf(HasSubstr("run it anew with what it is printed with, morphgrid run s.toml;"),
                    isSilent));
}

TEST(ChangedTools, AreThoseWhoseFilesSaySomethingElse) {
  const PrintTools then{samplePrinter(), sampleMaterial(), {}};
  const PrintAssessment run = assessPrint(flatGrid({6, 5, 2}, 0.2), then, {});
  EXPECT_THAT(changedTools(run, then), IsEmpty());
  PrintTools now = then;
  now.material.along.change = -0.4;
  EXPECT_THAT(changedTools(run, now), ElementsAre("material"));
  now = then;
  now.printer.bedX += 1;
  EXPECT_THAT(changedTools(run, now), ElementsAre("printer"));
}

TEST(ChangedTools, OfOlderStatesHaveOtherNames) {
  const PrintTools now{samplePrinter(), sampleMaterial(), {}};
  const PrintAssessment run{.printer = "another", .material = now.material.name, .obstacles = {}};
  EXPECT_THAT(changedTools(run, now), ElementsAre("printer"));
}

}  // namespace
}  // namespace morphgrid
