#include "report/explain_table.h"

#include <gmock/gmock.h>

#include <sstream>

#include "report/report_table.h"
#include "tests/report/sample_record.h"

namespace morphgrid {
namespace {

using testing::HasSubstr;
using testing::Not;

/// What a row is called: up to two spaces or its end.
std::string labelOf(const std::string& row) {
  const std::size_t begin = row.find_first_not_of(' ');
  return begin == row.npos ? "" : row.substr(begin, row.find("  ", begin) - begin);
}

TEST(ExplainTable, SaysWhatEachRowMeans) {
  RunRecord record = sampleRecord();
  record.inverse = InverseDesign{
      {}, {}, {{InverseStep::Kind::design, 0, 4, 5, 6, 2.5, 7, 8, 9, 0.5}}, "all steps done", {}};
  record.inverse->fromFlat = FromFlat{true, 2.25, {}, true, 1234, 1.5};
  record.feasibility->cells = {.inverted = 1, .collapsed = 2};
  record.feasibility->selfIntersection.cells = 3;
  const std::string table = toTable(record);
  const std::string explained = explainTable(table);
  std::istringstream rows(table.substr(table.find('\n') + 1));
  int count = 0;
  for (std::string row; std::getline(rows, row); ++count) {
    const std::string label = labelOf(row);
    const std::string word = label.substr(0, label.find(':'));
    EXPECT_THAT(explained, HasSubstr("\n  " + word)) << row;
  }
  EXPECT_GT(count, 15);
}

TEST(ExplainTable, IsSilentOnRowsThatAreNotThere) {
  const std::string explained = explainTable("net\n  largest strain   1 %\n  sheet metal  4\n");
  EXPECT_THAT(explained, HasSubstr("\n  largest strain\n"));
  EXPECT_THAT(explained, Not(HasSubstr("\n  net\n"))) << "that is the title";
  EXPECT_THAT(explained, Not(HasSubstr("isolines")));
}

}  // namespace
}  // namespace morphgrid
