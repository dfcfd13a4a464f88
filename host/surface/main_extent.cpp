#include "surface/main_extent.h"

#include <algorithm>
#include <vector>

namespace morphgrid {
namespace {

constexpr double kFarAway = 0.5;  // In sizes of the part.

struct Piece {
  Eigen::AlignedBox3d box;
  double area = 0;
};

double triangleArea(const TriangleMesh& mesh, Eigen::Index triangle) {
  const auto corner = [&](int n) { return mesh.vertices.col(mesh.triangles(n, triangle)); };
  const Eigen::Vector3d first = corner(1) - corner(0);
  const Eigen::Vector3d second = corner(2) - corner(0);
  return first.cross(second).norm() / 2;
}

std::vector<Piece> piecesOf(const TriangleMesh& mesh) {
  std::vector<Piece> pieces(mesh.triangles.cols());
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t) {
    for (const int vertex : mesh.triangles.col(t)) pieces[t].box.extend(mesh.vertices.col(vertex));
    pieces[t].area = triangleArea(mesh, t);
  }
  return pieces;
}

double sizeOf(const Piece& piece) { return piece.box.sizes().maxCoeff(); }

/// Pieces between which no gap is seen along an axis, as one; pieces: in the order of where they
/// begin.
std::vector<Piece> joinAlong(int axis, const std::vector<Piece>& pieces) {
  std::vector<Piece> joined;
  for (const Piece& piece : pieces) {
    if (joined.empty() || piece.box.min()[axis] > joined.back().box.max()[axis]) {
      joined.push_back(piece);
    } else {
      joined.back().box.extend(piece.box);
      joined.back().area += piece.area;
    }
  }
  return joined;
}

/// The largest of them and its neighbours that are not far away.
Piece mainOf(int axis, const std::vector<Piece>& joined) {
  const auto largest = std::max_element(joined.begin(), joined.end(),
                                        [](auto& a, auto& b) { return a.area < b.area; });
  Piece main = *largest;
  for (auto next = largest + 1; next != joined.end(); ++next) {
    if (next->box.min()[axis] - main.box.max()[axis] > kFarAway * sizeOf(main)) break;
    main.box.extend(next->box);
  }
  for (auto next = largest; next != joined.begin(); --next) {
    const Piece& before = *std::prev(next);
    if (main.box.min()[axis] - before.box.max()[axis] > kFarAway * sizeOf(main)) break;
    main.box.extend(before.box);
  }
  return main;
}

}  // namespace

Eigen::AlignedBox3d mainExtent(const TriangleMesh& mesh) {
  std::vector<Piece> pieces = piecesOf(mesh);
  for (std::size_t before = 0; before != pieces.size();) {
    before = pieces.size();
    for (int axis = 0; axis < 3; ++axis) {
      std::sort(pieces.begin(), pieces.end(), [&](const Piece& a, const Piece& b) {
        return a.box.min()[axis] < b.box.min()[axis];
      });
      const Piece main = mainOf(axis, joinAlong(axis, pieces));
      std::erase_if(pieces, [&](const Piece& piece) { return !main.box.contains(piece.box); });
    }
  }
  Eigen::AlignedBox3d extent;
  for (const Piece& piece : pieces) extent.extend(piece.box);
  return extent;
}

double surfaceArea(const TriangleMesh& mesh) {
  double area = 0;
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t) area += triangleArea(mesh, t);
  return area;
}

}  // namespace morphgrid
