// The sheet that a run leaves, read by VTK, beside its state and its report.
#include <gtest/gtest.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <nlohmann/json.hpp>

#include "core/read_file.h"
#include "state/run_state.h"
#include "tests/app/subprocess.h"
#include "tests/support/folders.h"
#include "tests/support/strut_list.h"
#include "tests/support/temporary_folder.h"

namespace morphgrid {
namespace {

Eigen::Vector3d tupleOf(vtkDataArray* array, int n) { return Eigen::Vector3d(array->GetTuple3(n)); }

TEST(PrintedSheet, IsTheStatesAndHasTheReportsDistance) {
  const TemporaryFolder folder;
  const ProcessResult run =
      runMorphgrid({"run", sourceFolder() / "scenes/egg_chair.toml", "--out", folder / "out",
                    "--quiet", "--set", "grid.nodes_long=6", "--set", "output.pictures=false"});
  ASSERT_EQ(run.exitCode, 0) << run.output;
  const RunState state = readState(folder / "out" / kStateFile);
  const GridShape& shape = state.grid.shape;
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName((folder / "out/printed.vtu").c_str());
  reader->Update();
  vtkUnstructuredGrid& sheet = *reader->GetOutput();
  vtkDataArray* morphed = sheet.GetPointData()->GetArray("morphed");
  vtkDataArray* target = sheet.GetPointData()->GetArray("target");
  ASSERT_EQ(sheet.GetNumberOfPoints(), shape.vertexCount());
  double squares = 0;
  int pairs = 0;
  for (int n = 0; n < shape.vertexCount(); ++n) {
    const Eigen::Vector3d printed(sheet.GetPoint(n));
    EXPECT_EQ(printed, state.grid.positions.col(n));
    EXPECT_NEAR(printed.z() - sheet.GetPoint(shape.column(n))[2], 0.3 * shape.place(n).layer,
                1e-12);
    const double square = (tupleOf(morphed, n) - tupleOf(target, n)).squaredNorm();
    if (std::isnan(square)) continue;
    squares += square;
    ++pairs;
  }
  EXPECT_EQ(pairs, shape.layerVertexCount());
  const auto report = nlohmann::json::parse(readFile(folder / "out/report.json"));
  const auto& distance = report["distance_to_target"];
  EXPECT_NEAR(100 * std::sqrt(squares / pairs) / distance["diagonal"].get<double>(),
              distance["rms_percent"].get<double>(), 1e-6);
  const auto struts = listStruts(shape);
  for (std::size_t n = 0; n < struts.size(); ++n) {
    const auto valueOf = [&](const char* name) {
      return sheet.GetCellData()->GetArray(name)->GetComponent(static_cast<vtkIdType>(n), 0);
    };
    EXPECT_EQ(valueOf("rest_length"), valueAt(state.grid.rest, struts[n]));
    EXPECT_EQ(valueOf("printed_length"), lengthAt(state.grid.positions, struts[n]));
  }
}

}  // namespace
}  // namespace morphgrid
