#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "app/scene_document.h"
#include "core/read_file.h"
#include "surface/mesh_configuration.h"
#include "tests/app/scene_files.h"
#include "tests/support/folders.h"

namespace morphgrid {
namespace {

std::string readDoc() { return readFile(sourceFolder() / "docs/scene_format.md"); }

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

TEST(SceneFormatDoc, HasTheKeysAsTheyAre) {
  EXPECT_EQ(readDoc(), withSceneKeys(readDoc()))
      << "cmake --build build/release --target scene_format writes them";
}

TEST(SceneFormatDoc, WithoutItsMarksIsRefused) {
  EXPECT_THROW(withSceneKeys("## [grid]\n"), InputError);
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
