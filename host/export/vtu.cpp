#include "export/vtu.h"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <algorithm>
#include <cassert>
#include <limits>
#include <vector>

#include "core/atomic_file.h"
#include "core/output_error.h"
#include "energy/bar_state.h"
#include "grid/shrink.h"
#include "grid/strain.h"

namespace morphgrid {
namespace {

vtkNew<vtkDoubleArray> pointArray(const Eigen::Matrix3Xd& values) {
  vtkNew<vtkDoubleArray> array;
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(values.cols());
  std::copy_n(values.data(), values.size(), array->GetPointer(0));
  return array;
}

void setPoints(vtkUnstructuredGrid& target, const Eigen::Matrix3Xd& positions) {
  vtkNew<vtkPoints> points;
  points->SetData(pointArray(positions));
  target.SetPoints(points);
}

void addPointArray(vtkUnstructuredGrid& target, const char* name, const Eigen::Matrix3Xd& values) {
  const vtkNew<vtkDoubleArray> array = pointArray(values);
  array->SetName(name);
  target.GetPointData()->AddArray(array);
}

void setLines(vtkUnstructuredGrid& target, const GridShape& shape) {
  vtkNew<vtkCellArray> lines;
  lines->AllocateExact(shape.strutCount(), 2 * vtkIdType{shape.strutCount()});
  forEachStrut(shape, [&](const Strut& strut) { lines->InsertNextCell({strut.from, strut.to}); });
  target.SetCells(VTK_LINE, lines);
}

template <typename Array, typename ValueOf>
void addCellArray(vtkUnstructuredGrid& target, const char* name, const GridShape& shape,
                  const ValueOf& valueOf) {
  vtkNew<Array> values;
  values->SetName(name);
  values->SetNumberOfValues(shape.strutCount());
  vtkIdType n = 0;
  forEachStrut(shape, [&](const Strut& strut) { values->SetValue(n++, valueOf(strut)); });
  target.GetCellData()->AddArray(values);
}

void addRestLengths(vtkUnstructuredGrid& target, const StrutGrid& grid) {
  addCellArray<vtkDoubleArray>(target, "rest_length", grid.shape,
                               [&](const Strut& strut) { return valueAt(grid.rest, strut); });
}

void addPlaces(vtkUnstructuredGrid& target, const GridShape& shape) {
  addCellArray<vtkIntArray>(target, "layer", shape,
                            [&](const Strut& strut) { return strut.layer; });
  addCellArray<vtkIntArray>(target, "direction", shape,
                            [&](const Strut& strut) { return static_cast<int>(strut.direction); });
}

void addBarArrays(vtkUnstructuredGrid& target, const StrutGrid& grid, const FramePlacement& place) {
  std::vector<BarState> bars;
  bars.reserve(grid.shape.strutCount());
  forEachStrut(grid.shape,
               [&](const Strut& strut) { bars.push_back(barStateAt(grid, place, strut)); });
  const auto add = [&](const char* name, double BarState::*figure) {
    auto next = bars.begin();
    addCellArray<vtkDoubleArray>(target, name, grid.shape,
                                 [&](const Strut&) { return (*next++).*figure; });
  };
  add("axial_energy", &BarState::axialEnergy);
  add("bending_energy", &BarState::bendingEnergy);
  add("shear_energy", &BarState::shearEnergy);
  add("twist_energy", &BarState::twistEnergy);
  add("bending_strain", &BarState::bendingStrain);
  add("joint_rotation", &BarState::jointRotation);
}

void fill(vtkUnstructuredGrid& target, const StrutGrid& grid, const Eigen::Matrix3Xd& positions,
          const JointRotations& rotations) {
  const GridShape& shape = grid.shape;
  const StrutValues shrinks = computeShrinks(grid);
  setPoints(target, positions);
  setLines(target, shape);
  addCellArray<vtkDoubleArray>(target, "strain", shape, [&](const Strut& strut) {
    return strainAt(grid, positions, strut);
  });
  addRestLengths(target, grid);
  addCellArray<vtkDoubleArray>(target, "shrink", shape,
                               [&](const Strut& strut) { return valueAt(shrinks, strut); });
  addPlaces(target, shape);
  if (grid.bars) {
    addBarArrays(target, grid, {positions, rotations});
  }
  target.GetCellData()->SetActiveScalars("strain");
}

/// 3 x vertexCount: NaN but for the layers that stand for the surface, see middleLayer().
Eigen::Matrix3Xd targetsOf(const GridShape& shape, const std::optional<Eigen::Matrix3Xd>& targets) {
  Eigen::Matrix3Xd points =
      Eigen::Matrix3Xd::Constant(3, shape.vertexCount(), std::numeric_limits<double>::quiet_NaN());
  if (targets) {
    layerOf(shape, points, (shape.layers - 1) / 2) = *targets;
    layerOf(shape, points, shape.layers / 2) = *targets;
  }
  return points;
}

void write(const std::filesystem::path& path, vtkUnstructuredGrid& grid) {
  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetInputData(&grid);
  // Into memory: VTK's pipeline prints what the disk refuses, whoever listens to the writer.
  writer->WriteToOutputStringOn();
  if (writer->Write() == 0) {
    throw OutputError(fmt::format("{}: cannot be written: VTK ran out of memory", path.string()));
  }
  writeFileAtomically(path, writer->GetOutputString());
}

}  // namespace

void exportVtu(const std::filesystem::path& path, const StrutGrid& grid,
               const Eigen::Matrix3Xd& positions, const JointRotations& rotations) {
  assert(positions.cols() == grid.shape.vertexCount());
  assert(rotations.cols() == (grid.bars ? positions.cols() : 0));
  vtkNew<vtkUnstructuredGrid> target;
  fill(*target, grid, positions, rotations);
  write(path, *target);
}

void exportPrintedVtu(const std::filesystem::path& path, const StrutGrid& grid,
                      const Eigen::Matrix3Xd& morphed,
                      const std::optional<Eigen::Matrix3Xd>& targets) {
  assert(morphed.cols() == grid.shape.vertexCount());
  assert(!targets || targets->cols() == grid.shape.layerVertexCount());
  vtkNew<vtkUnstructuredGrid> sheet;
  setPoints(*sheet, grid.positions);
  setLines(*sheet, grid.shape);
  addPointArray(*sheet, "morphed", morphed);
  addPointArray(*sheet, "target", targetsOf(grid.shape, targets));
  addRestLengths(*sheet, grid);
  addCellArray<vtkDoubleArray>(*sheet, "printed_length", grid.shape,
                               [&](const Strut& strut) { return lengthAt(grid.positions, strut); });
  addPlaces(*sheet, grid.shape);
  write(path, *sheet);
}

}  // namespace morphgrid
