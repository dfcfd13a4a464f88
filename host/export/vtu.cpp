#include "export/vtu.h"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <algorithm>
#include <cassert>
#include <vector>

#include "core/atomic_file.h"
#include "core/output_error.h"
#include "energy/bar_state.h"
#include "grid/shrink.h"
#include "grid/strain.h"

namespace morphgrid {
namespace {

void setPoints(vtkUnstructuredGrid& target, const Eigen::Matrix3Xd& positions) {
  vtkNew<vtkDoubleArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  coordinates->SetNumberOfTuples(positions.cols());
  std::copy_n(positions.data(), positions.size(), coordinates->GetPointer(0));
  vtkNew<vtkPoints> points;
  points->SetData(coordinates);
  target.SetPoints(points);
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
  addCellArray<vtkDoubleArray>(target, "rest_length", shape,
                               [&](const Strut& strut) { return valueAt(grid.rest, strut); });
  addCellArray<vtkDoubleArray>(target, "shrink", shape,
                               [&](const Strut& strut) { return valueAt(shrinks, strut); });
  addCellArray<vtkIntArray>(target, "layer", shape,
                            [&](const Strut& strut) { return strut.layer; });
  addCellArray<vtkIntArray>(target, "direction", shape,
                            [&](const Strut& strut) { return static_cast<int>(strut.direction); });
  if (grid.bars) {
    addBarArrays(target, grid, {positions, rotations});
  }
  target.GetCellData()->SetActiveScalars("strain");
}

}  // namespace

void exportVtu(const std::filesystem::path& path, const StrutGrid& grid,
               const Eigen::Matrix3Xd& positions, const JointRotations& rotations) {
  assert(positions.cols() == grid.shape.vertexCount());
  assert(rotations.cols() == (grid.bars ? positions.cols() : 0));
  vtkNew<vtkUnstructuredGrid> target;
  fill(*target, grid, positions, rotations);
  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetInputData(target);
  // Into memory: VTK's pipeline prints what the disk refuses, whoever listens to the writer.
  writer->WriteToOutputStringOn();
  if (writer->Write() == 0) {
    throw OutputError(fmt::format("{}: cannot be written: VTK ran out of memory", path.string()));
  }
  writeFileAtomically(path, writer->GetOutputString());
}

}  // namespace morphgrid
