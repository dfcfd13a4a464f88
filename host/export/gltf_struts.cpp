#include "export/gltf_struts.h"

#include <cmath>

#include "export/bar_mesh.h"
#include "export/gltf_parts.h"
#include "export/tube_mesh.h"
#include "grid/strain.h"
#include "shared/strain_color.h"

namespace morphgrid {
namespace {

int verticesPerStrut(StrutShape shape) {
  switch (shape) {
    case StrutShape::lines:
      return 2;
    case StrutShape::tubes:
      return kTubeMeshVertices;
    case StrutShape::bars:
      break;
  }
  return kBarMeshVertices;
}

Eigen::Matrix3Xd strutEnds(const GridShape& shape, const Eigen::Matrix3Xd& positions) {
  Eigen::Matrix3Xd ends(3, 2 * Eigen::Index{shape.strutCount()});
  Eigen::Index n = 0;
  forEachStrut(shape, [&](const Strut& strut) {
    ends.col(n++) = positions.col(strut.from);
    ends.col(n++) = positions.col(strut.to);
  });
  return ends;
}

/// A display's value as light (IEC 61966-2-1): glTF's vertex colours are light.
float lightOf(float displayed) {
  return displayed <= 0.04045F ? displayed / 12.92F : std::pow((displayed + 0.055F) / 1.055F, 2.4F);
}

/// The strain's colour of every strut, once for each of its vertices.
Eigen::Matrix3Xf strutColors(const StrutGrid& grid, const Eigen::Matrix3Xd& positions, int count) {
  const std::vector<double> strutStrains = strains(grid, positions);
  Eigen::Matrix3Xf colors(3, count * static_cast<Eigen::Index>(strutStrains.size()));
  for (std::size_t i = 0; i < strutStrains.size(); ++i) {
    const vec3 color = strainColor(static_cast<float>(strutStrains[i]));
    colors.middleCols(count * static_cast<Eigen::Index>(i), count).colwise() =
        Eigen::Vector3f(lightOf(color.r), lightOf(color.g), lightOf(color.b));
  }
  return colors;
}

/// Lines have no normals to shade by, and their colours are data.
tinygltf::Material lineMaterial() {
  tinygltf::Material material;
  material.name = "strain";
  material.extensions[kUnlit] = tinygltf::Value(tinygltf::Value::Object());
  return material;
}

/// Without light nobody could tell the sides of a solid.
tinygltf::Material solidMaterial() {
  tinygltf::Material material;
  material.name = "strain";
  material.pbrMetallicRoughness.metallicFactor = 0;
  material.pbrMetallicRoughness.roughnessFactor = 0.8;
  return material;
}

}  // namespace

StrutShape strutShapeOf(const StrutGrid& grid) {
  if (grid.shape.strutCount() > kMostSolidStruts) {
    return StrutShape::lines;
  }
  return grid.bars ? StrutShape::bars : StrutShape::tubes;
}

Eigen::Matrix3Xd strutVertices(const StrutGrid& grid, const Eigen::Matrix3Xd& positions,
                               const JointRotations& rotations) {
  switch (strutShapeOf(grid)) {
    case StrutShape::lines:
      return strutEnds(grid.shape, positions);
    case StrutShape::tubes:
      return tubeVertices(grid, positions);
    case StrutShape::bars:
      break;
  }
  return barVertices(grid, positions, rotations);
}

tinygltf::Primitive addStruts(tinygltf::Model& model, const StrutGrid& grid,
                              const Eigen::Matrix3Xd& positions, const JointRotations& rotations) {
  const StrutShape shape = strutShapeOf(grid);
  tinygltf::Primitive struts;
  struts.mode = shape == StrutShape::lines ? TINYGLTF_MODE_LINE : TINYGLTF_MODE_TRIANGLES;
  struts.attributes["POSITION"] =
      addPositions(model, strutVertices(grid, positions, rotations).cast<float>());
  struts.attributes["COLOR_0"] =
      addVectors(model, strutColors(grid, positions, verticesPerStrut(shape)));
  if (shape != StrutShape::lines) {
    struts.indices = addIndices(
        model, shape == StrutShape::bars ? barTriangles(grid.shape) : tubeTriangles(grid.shape));
  }
  return struts;
}

void addStrutNode(tinygltf::Model& model, tinygltf::Primitive struts) {
  const bool areLines = struts.mode == TINYGLTF_MODE_LINE;
  if (areLines) {
    model.extensionsUsed = {kUnlit};
  }
  addNode(model, "struts", areLines ? lineMaterial() : solidMaterial(), std::move(struts));
}

}  // namespace morphgrid
