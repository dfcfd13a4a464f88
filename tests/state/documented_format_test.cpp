// A reader of its own, written from docs/state_format.md.
#include <gmock/gmock.h>

#include <bit>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "core/read_file.h"
#include "tests/state/sample_state.h"
#include "tests/support/folders.h"
#include "tests/support/temporary_folder.h"

namespace morphgrid {
namespace {

using nlohmann::json;

std::uint64_t littleEndian(std::string_view bytes) {
  std::uint64_t value = 0;
  for (auto byte = bytes.rbegin(); byte != bytes.rend(); ++byte) {
    value = value << 8 | static_cast<unsigned char>(*byte);
  }
  return value;
}

/// What the file says of itself, and its numbers.
struct ReadByHand {
  json header;
  std::string data;

  explicit ReadByHand(const RunState& state) {
    const TemporaryFolder folder;
    writeState(folder / kStateFile, state);
    const std::string bytes = readFile(folder / kStateFile);
    const std::uint64_t length = littleEndian(std::string_view(bytes).substr(0, 8));
    header = json::parse(bytes.substr(8, length));
    data = bytes.substr(8 + length);
  }

  std::vector<std::size_t> shapeOf(const std::string& name) const {
    return header.at(name).at("shape");
  }
  std::string_view bytesOf(const std::string& name) const {
    const std::size_t begin = header.at(name).at("data_offsets").at(0);
    const std::size_t end = header.at(name).at("data_offsets").at(1);
    return std::string_view(data).substr(begin, end - begin);
  }
  /// A number of an F64 array, by its place in the file.
  double number(const std::string& name, std::size_t index) const {
    return std::bit_cast<double>(littleEndian(bytesOf(name).substr(8 * index, 8)));
  }
};

/// The rows of the document's tables: what stands in the first column, and in the second.
std::map<std::string, std::string> documented() {
  const std::string document = readFile(sourceFolder() / "docs" / "state_format.md");
  std::map<std::string, std::string> rows;
  const std::regex row(R"(\n\| `([a-z0-9_]+)` \| ([^|]*) \|)");
  for (std::sregex_iterator at(document.begin(), document.end(), row), end; at != end; ++at) {
    rows[(*at)[1]] = (*at)[2];
  }
  return rows;
}

/// The extents that "F64 `[L, V-1, 3]`" means for 3 layers of 4 x 3 vertices. N: as many as there
/// are.
std::vector<std::string> extentsOf(const std::string& typeAndShape) {
  static const std::map<std::string, std::string> sizes{{"L", "3"},   {"V", "3"},   {"U", "4"},
                                                        {"L-1", "2"}, {"V-1", "2"}, {"U-1", "3"}};
  const std::size_t open = typeAndShape.find('[') + 1;
  const std::string list = typeAndShape.substr(open, typeAndShape.find(']') - open);
  std::vector<std::string> extents;
  const std::regex extent(R"([^, ]+)");
  for (std::sregex_iterator at(list.begin(), list.end(), extent), end; at != end; ++at) {
    const auto size = sizes.find(at->str());
    extents.push_back(size == sizes.end() ? at->str() : size->second);
  }
  return extents;
}

bool fits(const std::vector<std::size_t>& shape, const std::vector<std::string>& extents) {
  if (shape.size() != extents.size()) return false;
  for (std::size_t n = 0; n < shape.size(); ++n) {
    if (extents[n] != "N" && extents[n] != std::to_string(shape[n])) return false;
  }
  return true;
}

TEST(StateFormat, HoldsWhatTheDocumentSaysAndNoMore) {
  const ReadByHand file(sampleState());
  const auto rows = documented();
  std::set<std::string> found;
  for (const auto& [name, entry] : file.header.items()) {
    if (name == "__metadata__") continue;
    found.insert(name);
    ASSERT_TRUE(rows.contains(name)) << name;
    EXPECT_EQ(entry.at("dtype"), rows.at(name).substr(0, rows.at(name).find(' '))) << name;
    const bool isShared = file.shapeOf(name) == std::vector<std::size_t>{1};
    EXPECT_TRUE(isShared || fits(file.shapeOf(name), extentsOf(rows.at(name)))) << name;
  }
  for (const auto& [name, text] : file.header.at("__metadata__").items()) {
    found.insert(name);
    EXPECT_TRUE(rows.contains(name)) << name;
  }
  for (const auto& [name, type] : rows) {
    EXPECT_TRUE(found.contains(name)) << name;
  }
}

TEST(StateFormat, ArraysLieAsTheDocumentSays) {
  const RunState state = sampleState();
  const ReadByHand file(state);
  const GridShape& shape = state.grid.shape;
  const auto strut = [](std::size_t k, std::size_t j, std::size_t i, std::size_t countV,
                        std::size_t countU) { return (k * countV + j) * countU + i; };
  for (int k = 0; k < 3; ++k) {
    for (int j = 0; j < 3; ++j) {
      for (int i = 0; i < 4; ++i) {
        const int vertex = shape.index(i, j, k);
        const std::size_t at = strut(k, j, i, 3, 4);
        for (std::size_t axis = 0; axis < 3; ++axis) {
          EXPECT_EQ(file.number("printed_positions", 3 * at + axis),
                    state.grid.positions(static_cast<int>(axis), vertex));
          EXPECT_EQ(file.number("positions", 3 * at + axis),
                    state.equilibrium().positions(static_cast<int>(axis), vertex));
        }
        if (i < 3) {
          EXPECT_EQ(file.number("rest_u", strut(k, j, i, 3, 3)), state.grid.rest.u[vertex]);
          EXPECT_EQ(file.number("design_rest_u", strut(k, j, i, 3, 3)),
                    state.design.rest[k].u(i, j));
        }
        if (j < 2) {
          EXPECT_EQ(file.number("stiffness_v", strut(k, j, i, 2, 4)),
                    state.grid.stiffness.v[vertex]);
        }
        if (k < 2) {
          EXPECT_EQ(file.number("rest_w", 0), state.grid.rest.w[vertex]) << "shared";
        }
      }
    }
  }
  EXPECT_EQ(file.number("design_bend_angles_v", 4 + 3), state.design.bendAngles.v(3, 1));
  EXPECT_EQ(file.number("target_from_grid", 3), 1) << "the translation is in the last column";
  EXPECT_EQ(file.number("history", 5), 12) << "the second sample's iteration";
  EXPECT_EQ(littleEndian(file.bytesOf("mesh_triangles").substr(12, 4)), 1u);
  EXPECT_EQ(file.bytesOf("ray_hits"), std::string_view("\1\1\0\1\1\0", 6));
  EXPECT_EQ(file.header.at("__metadata__").at("scene"), state.scene);
  EXPECT_EQ(json::parse(file.header.at("__metadata__").at("report").get<std::string>())["scene"],
            "sample");
}

TEST(StateFormat, GrowsByAsManyBytesAsTheDocumentSays) {
  const auto bytesPerGrid = [](const RunState& state) {
    const ReadByHand file(state);
    std::size_t bytes = 0;
    for (const auto& [name, entry] : file.header.items()) {
      const bool isOfTheGrid = name.find("history") == std::string::npos &&
                               name.find("mesh_") != 0 && name.find("ray_") != 0;
      if (name != "__metadata__" && isOfTheGrid) {
        bytes += entry.at("data_offsets").at(1).get<std::size_t>() -
                 entry.at("data_offsets").at(0).get<std::size_t>();
      }
    }
    return bytes;
  };
  RunState state = plainState();
  state.targets = state.record.inPlane->positions;
  constexpr std::size_t kConstant = 4 * 8 + 4 * 4 * 8 + 4 * 8 + 4;
  const std::size_t vertices = 36;
  EXPECT_LE(bytesPerGrid(state), 64 * vertices + 80 * vertices / 3 + kConstant);
}

}  // namespace
}  // namespace morphgrid
