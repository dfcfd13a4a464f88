// The section [print] of a scene, and what it means for a design.
#include <gmock/gmock.h>

#include "app/design_scene.h"
#include "print/strut_lay.h"
#include "tests/app/scene_files.h"
#include "tests/support/folders.h"

namespace morphgrid {
namespace {

using testing::AllOf;
using testing::HasSubstr;

const std::string kPrinter =
    "printer = '" + (sourceFolder() / "printers/prusa_mk4.toml").string() + "'\n";
const std::string kMaterial =
    "material = '" + (sourceFolder() / "materials/pla_0.08.toml").string() + "'\n";

/// Of two rings around a pin of 1.75 mm: HubShape's own test has it.
const double kHub = hubShapeOf({}, {0.45, 0.2}).diameter;

std::string printed(const std::string& keys) {
  return kBezierScene + std::string("nodes_long = 6\n[print]\n") + kPrinter + kMaterial + keys;
}

TEST(ScenePrint, IsReadWithItsFiles) {
  const Scene scene = SceneFiles(printed("scale = 20\npin = 1.0\nloops = 1\npasses = 8\n")).load();
  ASSERT_TRUE(scene.print);
  const PrintTools& tools = scene.print->tools;
  EXPECT_EQ(tools.request.scale, 20);
  EXPECT_EQ(tools.request.pin, 1.0);
  EXPECT_EQ(tools.request.clearance, 0.2);
  EXPECT_EQ(tools.request.loops, 1);
  EXPECT_EQ(tools.printer.bedX, 250);
  EXPECT_EQ(materialOf(tools).strut.passes, 8);
  EXPECT_EQ(tools.material.along.change, -0.42);
}

TEST(ScenePrint, FilesAreRelativeToTheScene) {
  SceneFiles files(kBezierScene + std::string("[print]\nprinter = \"../mine.toml\"\n") + kMaterial);
  EXPECT_THAT(files.problems(),
              AllOf(HasSubstr("scene.toml:7:11: print.printer must name a readable "
                              "printer file"),
                    HasSubstr("mine.toml")));
}

TEST(ScenePrint, NeedsPrinterAndMaterial) {
  EXPECT_THAT(SceneFiles(kBezierScene).problems({"print.scale=12"}),
              AllOf(HasSubstr("print.printer"), HasSubstr("print.material")));
  EXPECT_THAT(SceneFiles(printed("scale = -3\n")).problems(),
              HasSubstr("print.scale must be a number"));
  EXPECT_THAT(SceneFiles(printed("spool = 1\n")).problems(), HasSubstr("print.spool"));
}

TEST(ScenePrint, TheMaterialSetsWhatMayShrink) {
  EXPECT_DOUBLE_EQ(SceneFiles(printed("")).load().design.maxShrinkage, 0.42);
  EXPECT_DOUBLE_EQ(SceneFiles(printed("")).load({"grid.max_shrinkage=0.3"}).design.maxShrinkage,
                   0.3);
}

TEST(ScenePrint, BoundsAreThoseOfThePrintStrutByStrut) {
  const Scene scene = SceneFiles(printed("scale = 20\n")).load();
  const ShrinkBounds bounds = shrinkBoundsOf(scene, 20);
  const StrutLay lay{.along = 0.42, .across = -0.08, .hub = 0.05, .hubDiameter = kHub};
  for (const double mm : {5.0, 9.3, 15.0, 40.0}) {
    EXPECT_NEAR(bounds.at(mm / 20).most, lay.bounds(mm).most, 1e-12) << mm;
    EXPECT_NEAR(bounds.at(mm / 20).least, lay.bounds(mm).least, 1e-12) << mm;
  }
  EXPECT_EQ(shrinkBoundsOf(SceneFiles(kBezierScene).load(), std::nullopt).at(1).most, 0.4);
}

TEST(ScenePrint, TheFrameGetsTheSizesThatAreLaid) {
  Scene scene = SceneFiles(printed("scale = 20\n[material]\nmodel = \"frame\"\n")).load();
  const MaterialRequest material = materialOf(scene, 20);
  EXPECT_NEAR(*material.barWidth, 1.316 / 20, 1e-4);        // Three lines.
  EXPECT_NEAR(*material.barHeight, 0.8 * 1.52 / 20, 1e-9);  // Ten passes, swollen.
  EXPECT_NEAR(*material.jointRadius, kHub / 2 / 20, 1e-12);
  // As stiff as a round bar of a hub's diameter: pi d^4 / 64 = a^4 / 12.
  EXPECT_NEAR(std::pow(*material.postWidth, 4) / 12,
              std::numbers::pi * std::pow(2 * *material.jointRadius, 4) / 64, 1e-12);
  scene.material.barWidth = 0.1;
  EXPECT_EQ(*materialOf(scene, 20).barWidth, 0.1);
  EXPECT_FALSE(materialOf(scene, std::nullopt).barHeight);
}

TEST(ScenePrint, WithoutAScaleTheSheetThatIsLaidOutFitsTheBed) {
  const Scene scene =
      SceneFiles(printed("[material]\nmodel = \"frame\"\n[design]\nenforce_shrinkage = true\n"))
          .load();
  const SceneDesign designed = designScene(scene);
  ASSERT_TRUE(designed.sheet && designed.mmPerUnit);
  EXPECT_EQ(*designed.mmPerUnit, largestScale(scene.print->tools, designed.sheet->sheet.positions));
  EXPECT_EQ(designed.sheet->figures.strutsOutOfRange, 0);
  const ShrinkBounds bounds = shrinkBoundsOf(scene, designed.mmPerUnit);
  const GridShape shape = designed.design.rest.front().shape();
  const auto& at = designed.sheet->sheet.positions;
  for (const auto& layer : designed.design.rest) {
    forEachLateralStrut(shape, [&](const Strut& strut) {
      const double length = (at.col(strut.to) - at.col(strut.from)).norm();
      const double loss = 1 - layer.at(strut) / length;
      EXPECT_GE(loss, bounds.at(length).least);
      EXPECT_LE(loss, bounds.at(length).most);
    });
  }
}

}  // namespace
}  // namespace morphgrid
