#include "export/vtu.h"

#include <gtest/gtest.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>

#include "energy/bar_state.h"
#include "grid/shrink.h"
#include "grid/strain.h"
#include "tests/export/export_samples.h"
#include "tests/support/strut_list.h"

namespace morphgrid {
namespace {

class Vtu : public testing::TestWithParam<GridShape> {
 protected:
  Vtu() : sample(exportSample(GetParam())), struts(listStruts(GetParam())) {
    const TemporaryFolder folder;
    exportVtu(folder / "morph.vtu", sample.grid, sample.positions);
    EXPECT_EQ(folder.fileCount(), 1);
    reader->SetFileName((folder / "morph.vtu").c_str());
    reader->Update();
    EXPECT_EQ(reader->GetErrorCode(), 0);
  }

  vtkUnstructuredGrid& read() { return *reader->GetOutput(); }

  /// A cell array of one value per strut.
  vtkDataArray& cellArray(const char* name, int dataType) {
    vtkDataArray* array = read().GetCellData()->GetArray(name);
    EXPECT_NE(array, nullptr) << name;
    EXPECT_EQ(array->GetDataType(), dataType);
    EXPECT_EQ(array->GetNumberOfComponents(), 1);
    EXPECT_EQ(array->GetNumberOfTuples(), struts.size());
    return *array;
  }

  ExportSample sample;
  std::vector<Strut> struts;
  vtkNew<vtkXMLUnstructuredGridReader> reader;
};
INSTANTIATE_TEST_SUITE_P(Shapes, Vtu, testing::ValuesIn(kSampleShapes), shapeName);

TEST_P(Vtu, KeepsEveryPoint) {
  ASSERT_EQ(read().GetNumberOfPoints(), sample.positions.cols());
  EXPECT_EQ(read().GetPoints()->GetDataType(), VTK_DOUBLE);
  for (vtkIdType i = 0; i < sample.positions.cols(); ++i) {
    EXPECT_EQ(Eigen::Vector3d(read().GetPoint(i)), sample.positions.col(i));
  }
}

TEST_P(Vtu, StrutsAreLinesBetweenTheirEnds) {
  ASSERT_EQ(read().GetNumberOfCells(), struts.size());
  vtkNew<vtkIdList> ends;
  for (std::size_t i = 0; i < struts.size(); ++i) {
    EXPECT_EQ(read().GetCellType(i), VTK_LINE);
    read().GetCellPoints(i, ends);
    ASSERT_EQ(ends->GetNumberOfIds(), 2);
    EXPECT_EQ(ends->GetId(0), struts[i].from);
    EXPECT_EQ(ends->GetId(1), struts[i].to);
  }
}

TEST_P(Vtu, KeepsEveryValueOfTheStruts) {
  vtkDataArray& strain = cellArray("strain", VTK_DOUBLE);
  vtkDataArray& restLength = cellArray("rest_length", VTK_DOUBLE);
  vtkDataArray& shrink = cellArray("shrink", VTK_DOUBLE);
  vtkDataArray& layer = cellArray("layer", VTK_INT);
  vtkDataArray& direction = cellArray("direction", VTK_INT);
  const StrutValues shrinks = computeShrinks(sample.grid);
  const std::vector<double> strutStrains = strains(sample.grid, sample.positions);
  for (std::size_t i = 0; i < struts.size(); ++i) {
    EXPECT_EQ(strain.GetComponent(i, 0), strutStrains[i]);
    EXPECT_EQ(restLength.GetComponent(i, 0), valueAt(sample.grid.rest, struts[i]));
    EXPECT_EQ(shrink.GetComponent(i, 0), valueAt(shrinks, struts[i]));
    EXPECT_EQ(layer.GetComponent(i, 0), struts[i].layer);
    EXPECT_EQ(direction.GetComponent(i, 0), static_cast<int>(struts[i].direction));
  }
}

TEST_P(Vtu, DirectionsAreCodedAsPromised) {
  const auto codeOf = [&](const Strut& strut) {
    const int step = strut.to - strut.from;
    return step == 1 ? 0 : step == GetParam().verticesU ? 1 : 2;
  };
  vtkDataArray& direction = cellArray("direction", VTK_INT);
  for (std::size_t i = 0; i < struts.size(); ++i) {
    EXPECT_EQ(direction.GetComponent(i, 0), codeOf(struts[i]));
  }
}

TEST(FrameVtu, BarsKeepTheirState) {
  const TemporaryFolder folder;
  const FrameSample sample = frameSample({5, 3, 2});
  exportVtu(folder / "morph.vtu", sample.grid, sample.positions, sample.rotations);
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName((folder / "morph.vtu").c_str());
  reader->Update();
  const auto valueOf = [&](const char* name, std::size_t n) {
    vtkDataArray* array = reader->GetOutput()->GetCellData()->GetArray(name);
    EXPECT_NE(array, nullptr) << name;
    return array->GetComponent(static_cast<vtkIdType>(n), 0);
  };
  const std::vector<Strut> struts = listStruts(sample.grid.shape);
  double energy = 0;
  for (std::size_t n = 0; n < struts.size(); ++n) {
    const BarState bar = barStateAt(sample.grid, {sample.positions, sample.rotations}, struts[n]);
    EXPECT_EQ(valueOf("axial_energy", n), bar.axialEnergy);
    EXPECT_EQ(valueOf("bending_energy", n), bar.bendingEnergy);
    EXPECT_EQ(valueOf("shear_energy", n), bar.shearEnergy);
    EXPECT_EQ(valueOf("twist_energy", n), bar.twistEnergy);
    EXPECT_EQ(valueOf("bending_strain", n), bar.bendingStrain);
    EXPECT_EQ(valueOf("joint_rotation", n), bar.jointRotation);
    for (const char* part : {"axial_energy", "bending_energy", "shear_energy", "twist_energy"}) {
      energy += valueOf(part, n);
    }
  }
  const double whole = FrameEnergy(sample.grid).evaluate(sample.positions, sample.rotations).energy;
  EXPECT_NEAR(energy, whole, 1e-12 * whole);
}

class PrintedVtu : public testing::TestWithParam<GridShape> {
 protected:
  void write(const std::optional<Eigen::Matrix3Xd>& targets) {
    const TemporaryFolder folder;
    exportPrintedVtu(folder / "printed.vtu", sample.grid, sample.positions, targets);
    reader->SetFileName((folder / "printed.vtu").c_str());
    reader->Update();
  }
  vtkUnstructuredGrid& read() { return *reader->GetOutput(); }
  Eigen::Vector3d pointOf(const char* name, int vertex) {
    vtkDataArray* array = read().GetPointData()->GetArray(name);
    EXPECT_EQ(array->GetDataType(), VTK_DOUBLE);
    return Eigen::Vector3d(array->GetTuple3(vertex));
  }

  ExportSample sample = exportSample(GetParam());
  vtkNew<vtkXMLUnstructuredGridReader> reader;
};
INSTANTIATE_TEST_SUITE_P(Shapes, PrintedVtu, testing::ValuesIn(kSampleShapes), shapeName);

TEST_P(PrintedVtu, HasTheSheetItsShapeAndItsTarget) {
  const GridShape& shape = GetParam();
  const Eigen::Matrix3Xd targets = layerOf(shape, sample.positions, 0) * 1.5;
  write(targets);
  EXPECT_EQ(read().GetPoints()->GetDataType(), VTK_DOUBLE);
  ASSERT_EQ(read().GetNumberOfPoints(), shape.vertexCount());
  for (int n = 0; n < shape.vertexCount(); ++n) {
    EXPECT_EQ(Eigen::Vector3d(read().GetPoint(n)), sample.grid.positions.col(n));
    EXPECT_EQ(pointOf("morphed", n), sample.positions.col(n));
    const int layer = n / shape.layerVertexCount();
    const bool isMiddle =
        2 * layer == shape.layers - 1 || 2 * layer == shape.layers || 2 * layer == shape.layers - 2;
    if (isMiddle) {
      EXPECT_EQ(pointOf("target", n), targets.col(shape.column(n)));
    } else {
      EXPECT_TRUE(pointOf("target", n).array().isNaN().all());
    }
  }
}

TEST_P(PrintedVtu, HasTheLengthsOfStruts) {
  write(std::nullopt);
  EXPECT_TRUE(pointOf("target", 0).array().isNaN().all());
  const auto valueOf = [&](const char* name, std::size_t n) {
    return read().GetCellData()->GetArray(name)->GetComponent(static_cast<vtkIdType>(n), 0);
  };
  const std::vector<Strut> struts = listStruts(GetParam());
  ASSERT_EQ(read().GetNumberOfCells(), struts.size());
  for (std::size_t n = 0; n < struts.size(); ++n) {
    EXPECT_EQ(valueOf("rest_length", n), valueAt(sample.grid.rest, struts[n]));
    EXPECT_EQ(valueOf("printed_length", n), lengthAt(sample.grid.positions, struts[n]));
    EXPECT_EQ(valueOf("layer", n), struts[n].layer);
    EXPECT_EQ(valueOf("direction", n), static_cast<int>(struts[n].direction));
  }
}

TEST(FrameVtu, SpringsHaveNoBars) {
  const TemporaryFolder folder;
  const ExportSample sample = exportSample({2, 2, 2});
  exportVtu(folder / "morph.vtu", sample.grid, sample.positions);
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName((folder / "morph.vtu").c_str());
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetCellData()->GetNumberOfArrays(), 5);
}

}  // namespace
}  // namespace morphgrid
