#include "export/surface_files.h"

#include <gtest/gtest.h>

#include <sstream>

#include "tests/export/export_samples.h"

namespace morphgrid {
namespace {

void expectSameSurface(const SurfaceMesh& read, const SurfaceMesh& written) {
  EXPECT_EQ(read.vertices, written.vertices);
  EXPECT_EQ(read.normals, written.normals);
  EXPECT_EQ(read.triangles, written.triangles);
}

/// The next number; streams round to the nearest double.
template <typename Number>
Number next(std::istream& text) {
  std::string word;
  text >> word;
  std::size_t used = 0;
  const double value = std::stod(word, &used);
  EXPECT_EQ(used, word.size());
  return static_cast<Number>(value);
}

template <typename Scalar>
Eigen::Vector3<Scalar> nextVector(std::istream& bytes) {
  Eigen::Vector3<Scalar> vector;
  bytes.read(reinterpret_cast<char*>(vector.data()), sizeof(vector));
  return vector;
}

SurfaceMesh readPly(std::istream& bytes, int vertexCount, int triangleCount) {
  const std::string header =
      "ply\nformat binary_little_endian 1.0\ncomment morphgrid\nelement vertex " +
      std::to_string(vertexCount) +
      "\nproperty double x\nproperty double y\nproperty double z\n"
      "property float nx\nproperty float ny\nproperty float nz\n"
      "element face " +
      std::to_string(triangleCount) + "\nproperty list uchar int vertex_indices\nend_header\n";
  std::string found(header.size(), '\0');
  bytes.read(found.data(), found.size());
  EXPECT_EQ(found, header);
  SurfaceMesh mesh{Eigen::Matrix3Xd(3, vertexCount), Eigen::Matrix3Xd(3, vertexCount),
                   Eigen::Matrix3Xi(3, triangleCount)};
  for (int i = 0; i < vertexCount; ++i) {
    mesh.vertices.col(i) = nextVector<double>(bytes);
    mesh.normals.col(i) = nextVector<float>(bytes).cast<double>();
  }
  for (int i = 0; i < triangleCount; ++i) {
    EXPECT_EQ(bytes.get(), 3);
    mesh.triangles.col(i) = nextVector<int>(bytes);
  }
  return mesh;
}

/// Corners as "7//7", counted from 1, vertex and normal of the same number.
Eigen::Vector3i readObjFace(std::istream& line) {
  Eigen::Vector3i triangle;
  for (int& corner : triangle) {
    char slash[2] = {};
    int normal = 0;
    line >> corner >> slash[0] >> slash[1] >> normal;
    EXPECT_EQ(std::string(slash, 2), "//");
    EXPECT_EQ(normal, corner);
    --corner;
  }
  return triangle;
}

template <typename Matrix, typename Column>
void append(Matrix& matrix, const Column& column) {
  matrix.conservativeResize(Eigen::NoChange, matrix.cols() + 1);
  matrix.col(matrix.cols() - 1) = column;
}

Eigen::Vector3d readVector(std::istream& line) {
  Eigen::Vector3d vector;
  for (double& coordinate : vector) coordinate = next<double>(line);
  return vector;
}

SurfaceMesh readObj(std::istream& text) {
  SurfaceMesh mesh;
  for (std::string content; std::getline(text, content);) {
    std::istringstream line(content);
    std::string keyword;
    line >> keyword;
    if (keyword == "v") {
      append(mesh.vertices, readVector(line));
    } else if (keyword == "vn") {
      append(mesh.normals, readVector(line));
    } else if (keyword == "f") {
      append(mesh.triangles, readObjFace(line));
    } else {
      EXPECT_EQ(keyword, "#");
      continue;
    }
    EXPECT_TRUE(line && (line >> std::ws).eof()) << content;
  }
  return mesh;
}

class SurfaceFiles : public testing::TestWithParam<GridShape> {
 protected:
  SurfaceMesh surface = exportSample(GetParam()).surface;
  TemporaryFolder folder;
};
INSTANTIATE_TEST_SUITE_P(Shapes, SurfaceFiles, testing::ValuesIn(kSampleShapes), shapeName);

TEST_P(SurfaceFiles, PlyKeepsEveryNumber) {
  exportPly(folder / "morph.ply", surface);
  std::istringstream bytes(readFile(folder / "morph.ply"));
  SurfaceMesh rounded = surface;
  rounded.normals = surface.normals.cast<float>().cast<double>();
  expectSameSurface(readPly(bytes, surface.vertices.cols(), surface.triangles.cols()), rounded);
  EXPECT_TRUE(bytes && bytes.peek() == EOF);
  EXPECT_EQ(folder.fileCount(), 1);
}

TEST_P(SurfaceFiles, ObjKeepsEveryNumber) {
  exportObj(folder / "morph.obj", surface);
  std::istringstream text(readFile(folder / "morph.obj"));
  expectSameSurface(readObj(text), surface);
  EXPECT_EQ(folder.fileCount(), 1);
}

}  // namespace
}  // namespace morphgrid
