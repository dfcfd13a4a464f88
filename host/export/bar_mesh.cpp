#include "export/bar_mesh.h"

#include <array>

#include "energy/frame_energy.h"
#include "export/repeat_triangles.h"
#include "grid/bar_section.h"

namespace morphgrid {
namespace {

using Eigen::Vector3d;
using Ends = BeamTerm::Ends<double>;
using Ring = Eigen::Matrix<double, 3, 4>;

/// Corners of a section, counter-clockwise about the bar: signs along n and b.
const Eigen::Matrix<double, 2, 4> kCorners{{-1, 1, 1, -1}, {-1, -1, 1, 1}};

/// A bar's middle line, from the joint at 0 to the joint at `ends.arm`, and its sections.
class BentBar {
 public:
  BentBar(const Ends& ends, const Eigen::Array2d& rectangle)
      : ends_(ends), halves_(rectangle / 2), length_(ends.arm.norm()) {}

  /// share: 0 at the first joint, 1 at the second; beyond: by how much it reaches past it.
  Ring ringAt(double share, double beyond) const {
    const double s = share;
    const Vector3d a = length_ * ends_.a.col(0);
    const Vector3d b = length_ * ends_.b.col(0);
    const Vector3d point = s * s * (3 - 2 * s) * ends_.arm + s * (1 - s) * ((1 - s) * a - s * b);
    const Vector3d slope =
        6 * s * (1 - s) * ends_.arm + (1 - s) * (1 - 3 * s) * a + s * (3 * s - 2) * b;
    const Vector3d along = slope.normalized();
    const Vector3d across =
        along.cross(Vector3d((1 - s) * ends_.a.col(1) + s * ends_.b.col(1))).normalized();
    Eigen::Matrix<double, 3, 2> axes;
    axes << halves_[0] * across.cross(along), halves_[1] * across;
    return (axes * kCorners).colwise() + (point + beyond * along);
  }

 private:
  Ends ends_;
  Eigen::Array2d halves_;
  double length_;
};

/// Of a bar whose vertices begin at 0: sides from ring to ring, then both ends.
Eigen::Matrix3Xi trianglesOfBar() {
  Eigen::Matrix3Xi triangles(3, kBarMeshTriangles);
  Eigen::Index next = 0;
  const auto addQuad = [&](const std::array<int, 4>& ring) {
    triangles.col(next++) << ring[0], ring[1], ring[2];
    triangles.col(next++) << ring[0], ring[2], ring[3];
  };
  for (int first = 0; first < 4 * kBarMeshPieces; first += 4) {
    for (int n = 0; n < 4; ++n) {
      const int side = (n + 1) % 4;
      addQuad({first + n, first + side, first + 4 + side, first + 4 + n});
    }
  }
  addQuad({3, 2, 1, 0});
  const int last = 4 * kBarMeshPieces;
  addQuad({last, last + 1, last + 2, last + 3});
  return triangles;
}

/// By how much a bar reaches beyond its joints.
struct Reach {
  double first, second;
};

Reach reachBeyond(const GridShape& shape, const Strut& strut, double width) {
  if (!strut.isLateral()) {
    return {0, 0};
  }
  const int axis = static_cast<int>(strut.direction);
  const auto place = [&](int vertex) {
    const GridPlace at = shape.place(vertex);
    return ivec3(at.i, at.j, at.layer);
  };
  const bool begins = !hasStrut(sizeOf(shape), neighbour(place(strut.from), axis, -1), axis);
  const bool ends = !hasStrut(sizeOf(shape), place(strut.to), axis);
  return {begins ? width / 2 : 0, ends ? width / 2 : 0};
}

}  // namespace

Eigen::Matrix3Xd barVertices(const StrutGrid& grid, const Eigen::Matrix3Xd& positions,
                             const JointRotations& rotations) {
  const FramePlacement place{positions, rotations};
  Eigen::Matrix3Xd vertices(3, kBarMeshVertices * Eigen::Index{grid.shape.strutCount()});
  Eigen::Index next = 0;
  forEachStrut(grid.shape, [&](const Strut& strut) {
    const BeamTerm term = BeamTerm::of(grid, strut);
    const Eigen::Array2d rectangle = rectangleOf(term.section);
    const BentBar bent(place.endsOf(term, {strut.from, strut.to}), rectangle);
    const Reach reach = reachBeyond(grid.shape, strut, rectangle[0]);
    for (int n = 0; n <= kBarMeshPieces; ++n) {
      const double beyond = n == 0 ? -reach.first : n == kBarMeshPieces ? reach.second : 0;
      vertices.middleCols<4>(next) =
          bent.ringAt(static_cast<double>(n) / kBarMeshPieces, beyond).colwise() +
          positions.col(strut.from);
      next += 4;
    }
  });
  return vertices;
}

Eigen::Matrix3Xi barTriangles(const GridShape& shape) {
  return repeatTriangles(trianglesOfBar(), kBarMeshVertices, shape.strutCount());
}

}  // namespace morphgrid
