#include "report/notice.h"

#include <gtest/gtest.h>

namespace morphgrid {
namespace {

TEST(Notice, TheMostImportantComeFirstEachKindInItsOrder) {
  std::vector<Notice> notices{{"clamped"},
                              {"over the limit", Severity::printing},
                              {"lever"},
                              {"another equilibrium", Severity::result},
                              {"too close", Severity::printing},
                              {"saddle", Severity::result}};
  putMostImportantFirst(notices);
  EXPECT_EQ(textsOf(notices),
            (std::vector<std::string>{"another equilibrium", "saddle", "over the limit",
                                      "too close", "clamped", "lever"}));
}

}  // namespace
}  // namespace morphgrid
