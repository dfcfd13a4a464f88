#pragma once
#include <array>

#include "shared/topology.h"

namespace morphgrid {

/// The place of a vertex; a cell has that of its vertex with the lowest indices.
struct GridPlace {
  int i;  ///< Along u.
  int j;  ///< Along v.
  int layer;
  bool operator==(const GridPlace&) const = default;
};

/// A strut of the implicit topology: it leaves vertex `from` along +u, +v or +w.
struct Strut {
  enum class Direction { u, v, w };
  int from;
  int to;
  Direction direction;
  int layer;  ///< That of `from`.

  bool isLateral() const { return direction != Direction::w; }
};

/// An angle to be kept: vertex indices of the apex and of the ends of its two arms.
struct Corner {
  int apex;
  int a;
  int b;
  bool isLateral;  ///< Between two struts of a layer, not a strut and a post.
};

/// A cell of a layer, the paper's node.
struct Cell {
  GridPlace place;
  std::array<int, 4> vertices;  ///< At (0, 0), (1, 0), (0, 1), (1, 1) from its place.

  int vertex(int di, int dj) const { return vertices[2 * dj + di]; }
  /// The vertices counter-clockwise.
  std::array<int, 4> ring() const { return {vertices[0], vertices[1], vertices[3], vertices[2]}; }
};

/// Which vertices, struts, corners and cells a grid has: verticesU x verticesV x layers vertices
/// with struts between neighbours. The forEach... functions below visit what there is, by hasSpan()
/// of shared/topology.h; they are inlined, so that nobody needs a list.
struct GridShape {
  int verticesU;
  int verticesV;
  int layers;

  constexpr int layerVertexCount() const { return verticesU * verticesV; }
  constexpr int vertexCount() const { return layerVertexCount() * layers; }
  constexpr int cellsU() const { return verticesU - 1; }
  constexpr int cellsV() const { return verticesV - 1; }
  constexpr int layerCellCount() const { return cellsU() * cellsV(); }
  constexpr int strutCount(Strut::Direction direction) const {
    switch (direction) {
      case Strut::Direction::u:
        return cellsU() * verticesV * layers;
      case Strut::Direction::v:
        return verticesU * cellsV() * layers;
      default:
        return layerVertexCount() * (layers - 1);
    }
  }
  constexpr int lateralStrutCount() const {
    return strutCount(Strut::Direction::u) + strutCount(Strut::Direction::v);
  }
  constexpr int strutCount() const { return lateralStrutCount() + strutCount(Strut::Direction::w); }

  int index(int i, int j, int k) const {
    return vertexIndex({verticesU, verticesV, layers}, {i, j, k});
  }
  int index(const GridPlace& place) const { return index(place.i, place.j, place.layer); }
  /// The vertex of a column in layer k; columns have the indices of their vertices in layer 0.
  constexpr int index(int column, int k) const { return k * layerVertexCount() + column; }
  constexpr int column(int vertex) const { return vertex % layerVertexCount(); }
  constexpr GridPlace place(int vertex) const {
    return {vertex % verticesU, vertex / verticesU % verticesV, vertex / layerVertexCount()};
  }

  /// One layer of it.
  constexpr GridShape layer() const { return {verticesU, verticesV, 1}; }
  bool operator==(const GridShape&) const = default;
};

/// The shape as the functions of shared/topology.h take it.
inline ivec3 sizeOf(const GridShape& shape) {
  return {shape.verticesU, shape.verticesV, shape.layers};
}

/// visit(GridPlace), in index order.
template <typename Visit>
void forEachVertex(const GridShape& shape, Visit visit) {
  const ivec3 size = sizeOf(shape);
  for (int k = 0; k < shape.layers; ++k) {
    for (int j = 0; j < shape.verticesV; ++j) {
      for (int i = 0; i < shape.verticesU; ++i) {
        if (hasVertex(size, {i, j, k})) {
          visit(GridPlace{i, j, k});
        }
      }
    }
  }
}

/// visit(Cell), in the order of their places.
template <typename Visit>
void forEachCell(const GridShape& shape, Visit visit) {
  const ivec3 size = sizeOf(shape);
  forEachVertex(shape, [&](const GridPlace& place) {
    if (hasCell(size, {place.i, place.j})) {
      const int first = shape.index(place);
      const int above = first + shape.verticesU;
      visit(Cell{place, {first, first + 1, above, above + 1}});
    }
  });
}

/// visit(Strut), u before v before w at each vertex, vertices in index order.
template <typename Visit>
void forEachStrut(const GridShape& shape, Visit visit) {
  using enum Strut::Direction;
  const ivec3 size = sizeOf(shape);
  forEachVertex(shape, [&](const GridPlace& place) {
    const ivec3 at(place.i, place.j, place.layer);
    const int from = shape.index(place);
    if (hasStrut(size, at, 0)) {
      visit(Strut{from, from + 1, u, place.layer});
    }
    if (hasStrut(size, at, 1)) {
      visit(Strut{from, from + shape.verticesU, v, place.layer});
    }
    if (hasStrut(size, at, 2)) {
      visit(Strut{from, from + shape.layerVertexCount(), w, place.layer});
    }
  });
}

/// visit(Strut), those along u and v in the order of forEachStrut.
template <typename Visit>
void forEachLateralStrut(const GridShape& shape, Visit visit) {
  forEachStrut(shape, [&](const Strut& strut) {
    if (strut.isLateral()) {
      visit(strut);
    }
  });
}

/// visit(std::array<int, 4>, bool isLateral): the vertices, in a ring, of each cell and of each
/// upright rectangle between a lateral strut and the one above it.
template <typename Visit>
void forEachFace(const GridShape& shape, Visit visit) {
  const ivec3 size = sizeOf(shape);
  const int u = 1;
  const int v = shape.verticesU;
  const int w = shape.layerVertexCount();
  forEachVertex(shape, [&](const GridPlace& place) {
    const ivec3 low(place.i, place.j, place.layer);
    const int from = shape.index(place);
    const auto visitSpan = [&](const ivec3& steps, int a, int b) {
      if (hasSpan(size, low, low + steps)) {
        visit(std::array{from, from + a, from + a + b, from + b}, steps.z == 0);
      }
    };
    visitSpan({1, 1, 0}, u, v);
    visitSpan({1, 0, 1}, u, w);
    visitSpan({0, 1, 1}, v, w);
  });
}

/// visit(Corner): the four of each face; up to 12 have a vertex as their apex.
template <typename Visit>
void forEachCorner(const GridShape& shape, Visit visit) {
  forEachFace(shape, [&](const std::array<int, 4>& ring, bool isLateral) {
    for (int n = 0; n < 4; ++n) {
      visit(Corner{ring[n], ring[(n + 1) % 4], ring[(n + 3) % 4], isLateral});
    }
  });
}

}  // namespace morphgrid
