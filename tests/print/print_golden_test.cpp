// Whole files, byte for byte, so that nothing in them changes unseen.
#include <gtest/gtest.h>

#include "print/assembly_page.h"
#include "print/write_tier.h"
#include "tests/print/print_samples.h"
#include "tests/support/folders.h"
#include "tests/support/golden_text.h"

namespace morphgrid {
namespace {

TEST(PrintGolden, MapOfATier) {
  StrutGrid grid = flatGrid({3, 3, 2}, 0.2);
  grid.rest.u[0] = 0.3;  // Out of range.
  const PrintPlan plan = planPrint("golden", grid, samplePrinter(), sampleMaterial(),
                                   {.scale = 20, .enlargement = 1.0});
  EXPECT_EQ(differenceFromGolden(tierMap(plan, 0), "tier.svg"), "");
}

class GoldenGcode : public testing::TestWithParam<Flavour> {};

/// A cell, one of whose struts is laid half along, half across.
TEST_P(GoldenGcode, OfACell) {
  Printer printer = GetParam() == Flavour::klipper
                        ? readPrinter(sourceFolder() / "printers/klipper_350.toml")
                        : samplePrinter();
  printer.flavour = GetParam();
  StrutGrid grid = flatGrid({2, 2, 1}, 0.3);
  grid.rest.u[0] = 0.85;
  PrintMaterial material = sampleMaterial();
  material.hub.every = 1;
  const PrintPlan plan =
      planPrint("a cell", grid, printer, material, {.scale = 10, .enlargement = 1.0, .passes = 1});
  const std::string flavour = kFlavourWords[static_cast<std::size_t>(GetParam())];
  EXPECT_EQ(differenceFromGolden(writeTier(plan, 0, false).text, "cell_" + flavour + ".gcode"), "");
}

INSTANTIATE_TEST_SUITE_P(Flavours, GoldenGcode,
                         testing::Values(Flavour::marlin, Flavour::klipper, Flavour::rrf),
                         [](const auto& test) {
                           return kFlavourWords[static_cast<std::size_t>(test.param)];
                         });

}  // namespace
}  // namespace morphgrid
