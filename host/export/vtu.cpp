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

#include "core/atomic_file.h"
#include "core/error.h"
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

void setLines(vtkUnstructuredGrid& target, const std::vector<Strut>& struts) {
  vtkNew<vtkCellArray> lines;
  lines->AllocateExact(struts.size(), 2 * struts.size());
  for (const Strut& strut : struts) {
    lines->InsertNextCell({strut.from, strut.to});
  }
  target.SetCells(VTK_LINE, lines);
}

/// valueOf(i) is the value of strut i.
template <typename Array, typename ValueOf>
void addCellArray(vtkUnstructuredGrid& target, const char* name, const ValueOf& valueOf) {
  vtkNew<Array> values;
  values->SetName(name);
  values->SetNumberOfValues(target.GetNumberOfCells());
  for (vtkIdType i = 0; i < values->GetNumberOfValues(); ++i) {
    values->SetValue(i, valueOf(i));
  }
  target.GetCellData()->AddArray(values);
}

void fill(vtkUnstructuredGrid& target, const StrutGrid& grid, const Eigen::Matrix3Xd& positions) {
  const std::vector<Strut> struts = listStruts(grid.shape);
  const std::vector<double> strutStrains = strains(grid, positions);
  const StrutValues shrinks = computeShrinks(grid);
  setPoints(target, positions);
  setLines(target, struts);
  addCellArray<vtkDoubleArray>(target, "strain", [&](auto i) { return strutStrains[i]; });
  addCellArray<vtkDoubleArray>(target, "rest_length",
                               [&](auto i) { return valueAt(grid.rest, struts[i]); });
  addCellArray<vtkDoubleArray>(target, "shrink",
                               [&](auto i) { return valueAt(shrinks, struts[i]); });
  addCellArray<vtkIntArray>(target, "layer", [&](auto i) { return struts[i].layer; });
  addCellArray<vtkIntArray>(target, "direction",
                            [&](auto i) { return static_cast<int>(struts[i].direction); });
  target.GetCellData()->SetActiveScalars("strain");
}

}  // namespace

void exportVtu(const std::filesystem::path& path, const StrutGrid& grid,
               const Eigen::Matrix3Xd& positions) {
  assert(positions.cols() == grid.shape.vertexCount());
  vtkNew<vtkUnstructuredGrid> target;
  fill(*target, grid, positions);
  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetInputData(target);
  // Into memory: VTK's pipeline prints what the disk refuses, whoever listens to the writer.
  writer->WriteToOutputStringOn();
  if (writer->Write() == 0) {
    throw InputError(fmt::format("{}: cannot be written: VTK ran out of memory", path.string()));
  }
  writeFileAtomically(path, writer->GetOutputString());
}

}  // namespace morphgrid
