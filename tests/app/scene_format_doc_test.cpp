#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <sstream>

#include "core/read_file.h"
#include "surface/mesh_configuration.h"
#include "tests/app/scene_files.h"
#include "tests/support/folders.h"

namespace morphgrid {
namespace {

std::string readDoc() { return readFile(sourceFolder() / "docs/scene_format.md"); }

/// What follows `start` up to `end`; empty for lines that do not start so.
std::string between(const std::string& line, const std::string& start, char end) {
  if (line.rfind(start, 0) != 0) return "";
  return line.substr(start.size(), line.find(end, start.size()) - start.size());
}

struct DocumentedKey {
  std::string name;
  std::string defaultValue;
};

/// The cell of a table's row, without the quotes around code.
std::string cell(const std::string& row, int column) {
  std::istringstream cells(row);
  std::string text;
  for (int i = 0; i <= column; ++i) std::getline(cells, text, '|');
  const auto first = text.find_first_not_of(" `");
  return first == text.npos ? "" : text.substr(first, text.find_last_not_of(" `") - first + 1);
}

/// The keys that have a row in a table under the heading of their section. Subsections are about
/// other files.
std::vector<DocumentedKey> documentedKeys() {
  std::vector<DocumentedKey> keys;
  std::string section, line;
  bool otherFile = false;
  std::istringstream doc(readDoc());
  while (std::getline(doc, line)) {
    if (line.rfind("## ", 0) == 0) section = between(line, "## [", ']');
    if (line.rfind("##", 0) == 0) otherFile = line.rfind("###", 0) == 0;
    if (otherFile) continue;
    const std::string key = between(line, "| `", '`');
    if (key.empty()) continue;
    keys.push_back({section.empty() ? key : section + "." + key, cell(line, 4)});
  }
  return keys;
}

/// The fenced blocks of a language in order; "" for those without one.
std::vector<std::string> blocks(const std::string& language) {
  std::vector<std::string> found;
  std::string line;
  std::istringstream doc(readDoc());
  while (std::getline(doc, line)) {
    if (line.rfind("```", 0) != 0) continue;
    const bool wanted = line == "```" + language;
    std::string block;
    while (std::getline(doc, line) && line != "```") block += line + "\n";
    if (wanted) found.push_back(block);
  }
  return found;
}

TEST(SceneFormatDoc, ListsExactlyTheKnownKeys) {
  std::vector<std::string> names;
  for (const DocumentedKey& key : documentedKeys()) names.push_back(key.name);
  EXPECT_EQ(names, knownSceneKeys());
}

TEST(SceneFormatDoc, GivesTheRightDefaults) {
  const SceneFiles files(kBezierScene);
  const Scene scene = files.load();
  const std::map<std::string, double> expected = {
      {"grid.layers", scene.design.layers},
      {"grid.nodes_long", scene.design.nodesLong},
      {"grid.max_shrinkage", scene.design.maxShrinkage},
      {"grid.curvature_cutoff", scene.design.curvatureCutoff},
      {"weights.lateral", scene.weights.lateral},
      {"weights.vertical", scene.weights.vertical},
      {"weights.angle", scene.weights.angle},
      {"solver.tolerance", scene.solve.tolerance},
      {"solver.energy_tolerance", scene.solve.energyTolerance},
      {"solver.iteration_limit", scene.solve.iterationLimit},
      {"output.width", scene.pictures.width},
      {"output.height", scene.pictures.height},
  };
  std::size_t found = 0;
  for (const DocumentedKey& key : documentedKeys()) {
    const auto value = expected.find(key.name);
    if (value == expected.end()) continue;
    SCOPED_TRACE(key.name);
    ++found;
    EXPECT_EQ(std::stod(key.defaultValue), value->second);
  }
  EXPECT_EQ(found, expected.size());
}

TEST(SceneFormatDoc, ItsExamplesLoad) {
  const std::vector<std::string> examples = blocks("toml");
  ASSERT_EQ(examples.size(), 3u);
  const TemporaryFolder folder;
  folder.write("patches/egg_chair.toml", examples[1]);
  EXPECT_EQ(loadScene(folder.write("scene.toml", examples[0])).solve.tolerance, 1e-10);
  folder.write("face.obj", "v 0 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\n");
  EXPECT_EQ(readMeshConfiguration(folder.write("mesh.toml", examples[2])).samplesU, 100);
}

TEST(SceneFormatDoc, ItsErrorsLookLikeThat) {
  const TemporaryFolder folder;
  folder.write("scenes/patches/dome.toml", R"(control_points = [
  [[0, 0, 0], [1, 0, 1], [2, 0, 1], [3, 0, 0]],
  [[0, 1, 0], [1, 1, 1], [2, 1, 1]],
  [[0, 2, 0], [1, 2, 1], [2, 2, 1], [3, 2, 0]],
  [[0, 3, 0], [1, 3, 1], [2, 3, 1], [3, 3, 0]],
]
)");
  const auto scene = folder.write("scenes/dome.toml", R"([surface]
kind = "bezier"
patch = "patches/dome.toml"

[grid]
layers = 65
node_long = 20
nodes_u = 20
)");
  try {
    loadScene(scene, {"solver.tolerance=0"});
    FAIL() << "a bad scene was accepted";
  } catch (const InputError& error) {
    EXPECT_THAT(blocks(""), testing::Contains(folder.withoutPath(error.what()) + "\n"));
  }
}

}  // namespace
}  // namespace morphgrid
