#include <vtkFloatArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkLinearSubdivisionFilter.h>
#include <vtkNew.h>
#include <vtkPLYWriter.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <Eigen/Geometry>
#include <cstdio>
#include <filesystem>

#include "torso_body.h"

// Writes a torso to a mesh file: make_torso FILE.ply

namespace morphgrid {
namespace {

using Eigen::Vector3d;

/// The whole body with air around it, in cm.
const Eigen::AlignedBox3d kBox(Vector3d(-31, -17, -15), Vector3d(31, 80, 14));
constexpr double kSpacing = 0.6;  ///< Spacing of the lattice, in cm.
constexpr int kRefinements = 2;   ///< Each halves the edges.

/// Values grow inwards: vtkFlyingEdges3D turns triangles to face smaller ones.
vtkNew<vtkImageData> sampleField() {
  const Eigen::Vector3i counts = (kBox.sizes() / kSpacing).cast<int>().array() + 2;
  vtkNew<vtkImageData> lattice;
  lattice->SetOrigin(kBox.min().x(), kBox.min().y(), kBox.min().z());
  lattice->SetSpacing(kSpacing, kSpacing, kSpacing);
  lattice->SetDimensions(counts.data());
  vtkNew<vtkFloatArray> values;
  values->SetNumberOfValues(lattice->GetNumberOfPoints());
  for (vtkIdType n = 0; n < lattice->GetNumberOfPoints(); ++n) {
    values->SetValue(n, static_cast<float>(-torsoField(Vector3d(lattice->GetPoint(n)))));
  }
  lattice->GetPointData()->SetScalars(values);
  return lattice;
}

Vector3d gradient(const Vector3d& point) {
  constexpr double kStep = 1e-4;
  Vector3d result;
  for (int axis = 0; axis < 3; ++axis) {
    const Vector3d step = kStep * Vector3d::Unit(axis);
    result[axis] = (torsoField(point + step) - torsoField(point - step)) / (2 * kStep);
  }
  return result;
}

/// Newton's method along the gradient; the second step leaves about 1e-6.
Vector3d ontoSkin(Vector3d point) {
  for (int step = 0; step < 2; ++step) {
    const Vector3d slope = gradient(point);
    point -= torsoField(point) / slope.squaredNorm() * slope;
  }
  return point;
}

/// A quick, coarse surface whose triangles are halved twice and put onto the skin: faster than a
/// fine lattice, most of which is air and flesh.
vtkNew<vtkPolyData> makeTorso() {
  const vtkNew<vtkImageData> lattice = sampleField();
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(lattice);
  contour->SetValue(0, 0);
  contour->ComputeNormalsOff();
  contour->ComputeScalarsOff();
  vtkNew<vtkLinearSubdivisionFilter> refine;
  refine->SetInputConnection(contour->GetOutputPort());
  refine->SetNumberOfSubdivisions(kRefinements);
  refine->Update();
  vtkNew<vtkPolyData> torso;
  torso->ShallowCopy(refine->GetOutput());
  vtkPoints* points = torso->GetPoints();
  for (vtkIdType n = 0; n < points->GetNumberOfPoints(); ++n) {
    const Vector3d moved = ontoSkin(Vector3d(points->GetPoint(n)));
    points->SetPoint(n, moved.data());
  }
  return torso;
}

/// Whole or not at all: readers never see half a file.
bool write(vtkPolyData* torso, const std::filesystem::path& file) {
  auto part = file;
  part.replace_extension(".part.ply");  // VTK insists on the last one.
  vtkNew<vtkPLYWriter> writer;
  writer->SetInputData(torso);
  writer->SetFileName(part.c_str());
  writer->SetFileTypeToBinary();
  std::error_code error;
  if (writer->Write() == 1 && writer->GetErrorCode() == 0) {
    std::filesystem::rename(part, file, error);
    if (!error) return true;
  }
  std::filesystem::remove(part, error);
  return false;
}

}  // namespace
}  // namespace morphgrid

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: make_torso FILE.ply\n", stderr);
    return 2;
  }
  const vtkNew<vtkPolyData> torso = morphgrid::makeTorso();
  if (morphgrid::write(torso, argv[1])) return 0;
  std::fprintf(stderr, "make_torso: cannot write %s\n", argv[1]);
  return 1;
}
