#pragma once
#include "energy/corner_term.h"
#include "energy/strut_term.h"

namespace morphgrid {

/// The energy of a grid is the sum of its terms. A type of term (of constraint) has one file here
/// and one line below; shaders/energy holds its twin. A term depends on kEdges edges of the grid,
/// which have kVertices different ends, and on nothing else, so that moving the grid changes
/// nothing. It has, with EdgeVectors<kEdges> e for the edges and z for how they change, gradients
/// by edges, and units of the grid:
///
/// - static void forEach(grid, visit): visit(term, EdgeStencil<kEdges>) for all of a grid that
///   count;
/// - evaluate(e): energy and gradient;
/// - hessianProduct(e, z): how the gradient changes, exactly;
/// - gaussNewton(e): 3 kEdges square, positive semi-definite; ties the device's blocks to
/// evaluate()
///   in tests;
/// - gradientByRest(e): the gradient's derivative by the rest value;
/// - projectionWeight(): w of projective dynamics' w |e - p|^2, of every edge.
///
/// visit(term, stencil) for all terms of all types.
template <typename Visit>
void forEachTerm(const StrutGrid& grid, Visit visit) {
  StrutTerm::forEach(grid, visit);
  CornerTerm::forEach(grid, visit);
}

}  // namespace morphgrid
