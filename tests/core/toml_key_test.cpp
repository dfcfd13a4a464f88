#include "core/toml_key.h"

#include <gmock/gmock.h>

#include "core/document_toml_key.h"
#include "core/error.h"
#include "core/key_place.h"
#include "core/read_toml_key.h"
#include "tests/support/temporary_folder.h"

namespace morphgrid {
namespace {

enum class Colour { red, blue };
constexpr std::array kColourWords = {"red", "blue"};

struct Round {
  double radius = 1.5;
};
struct Square {
  std::optional<double> side;
};
struct Extra {
  int count = 0;
};

/// Something with a part of every sort.
struct Thing {
  Colour colour = Colour::blue;
  bool isSolid = true;
  std::string name = "thing";
  double low = -1e-9, high = 2;
  std::filesystem::path file;
  std::variant<Round, Square> shape;
  std::optional<Extra> extra;
  long size = 7;
};

const RecordKinds<Thing> kKinds{{"round", "square"}, [](std::size_t kind) {
                                  Thing thing;
                                  if (kind == 1) thing.shape = Square();
                                  return thing;
                                }};

std::vector<TomlKey<Thing>> thingKeys() {
  return {
      {.name = "colour", .value = wordKey(at(&Thing::colour), kColourWords), .meaning = "C."},
      {.name = "solid", .value = booleanKey(at(&Thing::isSolid)), .meaning = "S."},
      {.name = "name",
       .value = textKey(at(&Thing::name)),
       .otherwise = [](Thing& thing) { thing.name = "left out"; },
       .meaning = "N."},
      {.name = "span",
       .value = numberPairKey(at(&Thing::low), at(&Thing::high), fromTo(-2, 2)),
       .unit = "m",
       .meaning = "P."},
      {.name = "file",
       .value = fileKey(at(&Thing::file), "drawing", "(draw one)"),
       .meaning = "F."},
      {.name = "radius",
       .value = numberKey(within<Round>(&Thing::shape, &Round::radius), above(0)),
       .kinds = {0},
       .meaning = "R."},
      {.name = "side",
       .value = numberKey(within<Square>(&Thing::shape, &Square::side)),
       .kinds = {1},
       .meaning = "Q."},
      {.name = "count",
       .value = integerKey(at(&Thing::extra, &Extra::count), {.low = 1}),
       .meaning = "X."},
      {.name = "size",
       .value = integerKey(at(&Thing::size), {1, 9}),
       .isRequired = true,
       .meaning = "Z."},
  };
}

class ThingFile : public testing::Test {
 protected:
  Thing read(const std::string& text, Thing thing = {}) {
    const auto file = folder_.write("thing.toml", text);
    TomlReader reader(file, parseToml(file));
    TomlSection root = reader.root();
    TomlKeyReader<Thing> values(reader, root, thing);
    for (const TomlKey<Thing>& key : thingKeys()) values.read(key);
    reader.reportUnknownKeys();
    reader.problems.throwIfAny();
    return thing;
  }
  std::string problems(const std::string& text) {
    try {
      read(text);
    } catch (const InputError& error) {
      return folder_.withoutPath(error.what());
    }
    return "";
  }

  TemporaryFolder folder_;
};

TEST_F(ThingFile, FillsItsRecord) {
  folder_.write("d.png", "");
  const Thing thing = read(
      "colour = \"red\"\nsolid = false\nname = \"N\"\nspan = [0, 1.5]\nfile = \"d.png\"\nradius = "
      "3\n"
      "count = 4\nsize = 2\n");
  EXPECT_EQ(thing.colour, Colour::red);
  EXPECT_FALSE(thing.isSolid);
  EXPECT_EQ(thing.name, "N");
  EXPECT_EQ(thing.low, 0);
  EXPECT_EQ(thing.high, 1.5);
  EXPECT_EQ(thing.file, folder_ / "d.png");
  EXPECT_EQ(std::get<Round>(thing.shape).radius, 3);
  EXPECT_EQ(thing.extra->count, 4);
  EXPECT_EQ(thing.size, 2);
}

TEST_F(ThingFile, LeavesWhatItDoesNotGive) {
  const Thing thing = read("");
  EXPECT_EQ(thing.colour, Colour::blue);
  EXPECT_EQ(thing.name, "left out");
  EXPECT_FALSE(thing.extra);
  EXPECT_EQ(thing.size, 7);
}

TEST_F(ThingFile, ChecksWhatBelongsToAnotherKindOfRecord) {
  EXPECT_EQ(std::get<Round>(read("side = 3\n").shape).radius, 1.5);
  EXPECT_EQ(problems("side = nan\n"), "thing.toml:1:8: side must be a finite number, got nan");
  Thing square;
  square.shape = Square();
  EXPECT_EQ(std::get<Square>(read("side = 3\n", square).shape).side, 3);
}

TEST_F(ThingFile, IsToldWhatItMayHold) {
  EXPECT_EQ(
      problems("colour = \"green\"\nspan = [0, 3]\nsize = 0\ncolor = 1\nfile = \"none\"\n"),
      "thing.toml:1:10: colour must be \"red\" or \"blue\", got \"green\"\n"
      "thing.toml:2:12: span[1] must be a number >= -2 and <= 2, got 3\n"
      "thing.toml:3:8: size must be an integer >= 1 and <= 9, got 0\n"
      "thing.toml:4:1: unknown key color; did you mean colour?\n"
      "thing.toml:5:8: file must name a readable drawing, got none: No such file or directory "
      "(draw one)");
}

TEST_F(ThingFile, IsDocumentedByItsKeys) {
  EXPECT_EQ(KeyDocument<Thing>(kKinds).table(thingKeys()),
            "| Key | Type | Range | Default | Meaning |\n"
            "| --- | --- | --- | --- | --- |\n"
            "| `colour` | string | `\"red\"`, `\"blue\"` | `\"blue\"` | C. |\n"
            "| `solid` | boolean |  | `true` | S. |\n"
            "| `name` | string | any | `\"left out\"` | N. |\n"
            "| `span` | 2 numbers, m | each >= -2 and <= 2 | `[-1e-9, 2]` | P. |\n"
            "| `file` | string | a readable file | none | F. |\n"
            "| `radius` | number | > 0 | `1.5` | R. Only for `\"round\"`. |\n"
            "| `side` | number | any | none | Q. Only for `\"square\"`. |\n"
            "| `count` | integer | >= 1 | none | X. |\n"
            "| `size` | integer | >= 1 and <= 9 | required | Z. |\n");
}

TEST(KindsInWords, NameTheFewer) {
  const std::vector<std::string> words = {"a", "b", "c"};
  EXPECT_EQ(kindsInWords({}, words), "");
  EXPECT_EQ(kindsInWords({0, 1, 2}, words), "");
  EXPECT_EQ(kindsInWords({1}, words), "Only for `\"b\"`");
  EXPECT_EQ(kindsInWords({0, 2}, words), "Not for `\"b\"`");
}

}  // namespace
}  // namespace morphgrid
