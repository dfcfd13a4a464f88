// Values that options refuse: told with the option's name, in few words.
#include "app/command_options.h"

#include <gtest/gtest.h>

namespace morphgrid {
namespace {

/// What the option says of a value; empty where it takes it.
std::string answerTo(const std::string& value, const CLI::Validator& validator) {
  CLI::App app;
  std::string taken;
  app.add_option("--it", taken)->check(validator);
  try {
    app.parse(std::vector<std::string>{value, "--it"});  // CLI11 reads them from the back.
  } catch (const CLI::ParseError& error) {
    return error.what();
  }
  EXPECT_EQ(taken, value);
  return "";
}

TEST(CommandOptions, NumbersOutOfRangeAreRefused) {
  const CLI::Validator positive = within(aboveUpTo(0, 1e6));
  EXPECT_EQ(answerTo("0.5", positive), "");
  EXPECT_EQ(answerTo("1e6", positive), "");
  for (const std::string value : {"0", "-3", "nan", "inf", "1e300", "three", "3mm"}) {
    EXPECT_EQ(answerTo(value, positive), "--it: must be a number > 0 and <= 1e+06, got " + value);
  }
}

TEST(CommandOptions, WholeNumbersHaveNoSign) {
  EXPECT_EQ(answerTo("0", wholeNumber()), "");
  EXPECT_EQ(answerTo("18446744073709551615", wholeNumber()), "");
  for (const std::string value : {"-1", "1.5", "18446744073709551616", "x"}) {
    EXPECT_EQ(answerTo(value, wholeNumber()),
              "--it: must be an integer >= 0 and < 2^64, got " + value);
  }
}

}  // namespace
}  // namespace morphgrid
