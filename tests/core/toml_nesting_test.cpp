#include "core/toml_nesting.h"

#include <gmock/gmock.h>

#include "core/error.h"
#include "core/toml_document.h"
#include "tests/support/temporary_folder.h"

namespace morphgrid {
namespace {

std::string repeated(const std::string& part, int count) {
  std::string text;
  for (int n = 0; n < count; ++n) text += part;
  return text;
}

/// Texts that have so many levels, each by another way of nesting or by several together.
std::vector<std::string> textsOf(int levels) {
  const int half = levels / 2;
  const int rest = levels - half;
  return {
      "a = " + repeated("[", levels) + "1" + repeated("]", levels) + "\n",
      "b = " + repeated("{ k = ", levels) + "1" + repeated(" }", levels) + "\n",
      "c" + repeated(".k", levels) + " = 1\n",
      "[d" + repeated(".k", levels - 1) + "]\nx = 1\n",
      "[e" + repeated(".k", half - 1) + "]\nx" + repeated(".y", rest) + " = 1\n",
      "f" + repeated(".k", half) + " = " + repeated("[", rest) + repeated("]", rest) + "\n",
      "g = { x" + repeated(".y", levels - 1) + " = 1, z = 2 }\n",
      "h = [ '''it's [''', \"\\\"[[\", " + repeated("[", levels - 1) + repeated("]", levels - 1) +
          " ]\n",
  };
}

TEST(TomlNesting, IsCountedAlikeInAllItsWays) {
  for (const std::string& text : textsOf(kMostTomlLevels)) {
    EXPECT_FALSE(findTooDeepNesting(text)) << text;
    EXPECT_NO_THROW(parseTomlText(text, "t.toml")) << text;  // They are valid.
  }
  for (const std::string& text : textsOf(kMostTomlLevels + 1)) {
    EXPECT_TRUE(findTooDeepNesting(text)) << text;
  }
}

TEST(TomlNesting, OfStringsCommentsAndNeighboursCountsNothing) {
  const std::string brackets = repeated("[{a.", 40);
  for (const std::string& text :
       {"a = \"" + brackets + "\"\n", "a = '" + brackets + "'\n", "# " + brackets + "\n",
        "a = \"\"\"\n" + brackets + "\"\"\"\"\"\n", "a = '''\n" + brackets + "'''\n",
        "a = 1 # " + brackets, repeated("[a.b]\nx.y = 1.5\n", 40),
        "a = [" + repeated("[1.5, 2.5], ", 40) + "]\n", "a = [\n" + repeated("1.5,\n", 40) + "]\n",
        repeated("[[t]]\nx = { y = [1] }\n", 40)}) {
    EXPECT_FALSE(findTooDeepNesting(text)) << text;
  }
}

TEST(TomlNesting, GoesOnBehindStrings) {
  const std::string deep = repeated("[", 40);
  for (const std::string start :
       {"\"a\"", "'a'", "'''a'''", "''''a'''''", "\"\"\"a\"\"\"\"\"", "\"a\\\\\"", "\"a\n", "''"}) {
    EXPECT_TRUE(findTooDeepNesting("x = [" + start + ", " + deep)) << start;
  }
  EXPECT_FALSE(findTooDeepNesting("x = [\"a\\\", " + deep));  // The string has not ended.
  EXPECT_FALSE(findTooDeepNesting("x = \"\\"));
}

TEST(TomlNesting, IsRefusedWithItsPlace) {
  const TemporaryFolder folder;
  const auto file =
      folder.write("t.toml", "a = 1\nb = [\n" + repeated("[", 40) + repeated("]", 40) + "]\n");
  const auto problemOf = [&](const std::vector<std::string>& overrides) -> std::string {
    try {
      parseToml(file, overrides);
    } catch (const InputError& error) {
      return folder.withoutPath(error.what());
    }
    return "";
  };
  const std::string why = ": more than 32 levels of arrays, tables and dotted keys";
  EXPECT_EQ(problemOf({}), "t.toml:3:32" + why);
  const std::string override = "a" + repeated(".b", 33) + "=1";
  EXPECT_EQ(problemOf({override}), "t.toml:3:32" + why + "\n--set " + override + why);
}

}  // namespace
}  // namespace morphgrid
