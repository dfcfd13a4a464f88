// What a fitted material may replace: nothing that somebody would miss.
#include "print/calibration_output.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "core/read_file.h"
#include "print/calibration_fit.h"
#include "tests/print/print_samples.h"
#include "tests/support/folders.h"
#include "tests/support/temporary_folder.h"

namespace morphgrid {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class CalibrationOutput : public testing::Test {
 protected:
  CalibrationOutput() {
    folder_.write("table.csv", "lengths");
    folder_.write("printer.toml", readFile(sourceFolder() / "printers/prusa_mk4.toml"));
    folder_.write("material.toml", printMaterialText(sampleMaterial()));
  }

  std::string refusalOf(const std::filesystem::path& output) const {
    try {
      requireReplaceable(output, {{folder_ / "table.csv", "the table"},
                                  {folder_ / "printer.toml", "the printer file"},
                                  {folder_ / "material.toml", "the material file"}});
    } catch (const InputError& error) {
      return folder_.withoutPath(error.what());
    }
    return "";
  }

  TemporaryFolder folder_;
};

TEST_F(CalibrationOutput, SourcesStay) {
  EXPECT_EQ(refusalOf(folder_ / "table.csv"),
            "table.csv: is the table, which would be lost: name another file to write, --out "
            "ANOTHER");
  EXPECT_THAT(refusalOf(folder_ / "printer.toml"), HasSubstr("is the printer file"));
  EXPECT_THAT(refusalOf(folder_ / "material.toml"), HasSubstr("is the material file"));
  EXPECT_THAT(refusalOf(folder_.path() / "." / "table.csv"), HasSubstr("is the table"));
  std::filesystem::create_symlink(folder_ / "table.csv", folder_ / "link.toml");
  EXPECT_THAT(refusalOf(folder_ / "link.toml"), HasSubstr("is the table"));
}

TEST_F(CalibrationOutput, SoDoFilesOfOthers) {
  const auto isRefused =
      AllOf(HasSubstr("is no material that calibrate fit wrote"), HasSubstr("--out ANOTHER"));
  EXPECT_THAT(refusalOf(folder_.write("scene.toml", "[surface]\n")), isRefused);
  EXPECT_THAT(refusalOf(folder_.write("notes.txt", "my notes")), isRefused);
  EXPECT_THAT(refusalOf(folder_.write("copy.toml", printMaterialText(sampleMaterial()))),
              isRefused);
}

TEST_F(CalibrationOutput, AnEarlierFitIsReplaced) {
  EXPECT_EQ(refusalOf(folder_ / "new.toml"), "");
  EXPECT_EQ(refusalOf(folder_ / "missing/new.toml"), "");
  const PrintMaterial fitted =
      fittedMaterial(sampleMaterial(), {.along = {-0.4, 0.01}, .across = {0.05, 0.01}}, "t.csv",
                     "a printer", 2026);
  EXPECT_EQ(refusalOf(folder_.write("fitted.toml", printMaterialText(fitted))), "");
}

}  // namespace
}  // namespace morphgrid
