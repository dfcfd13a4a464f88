#include "surface/subdivide_mesh.h"

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/subdivision_method_3.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "core/error.h"
#include "surface/join_vertices.h"
#include "surface/mesh_source.h"

namespace morphgrid {
namespace {

using Point = CGAL::Simple_cartesian<double>::Point_3;
using HalfedgeMesh = CGAL::Surface_mesh<Point>;
namespace processing = CGAL::Polygon_mesh_processing;

struct Soup {
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> triangles;
};

Soup soupOf(const TriangleMesh& mesh) {
  Soup soup;
  for (const auto& p : mesh.vertices.colwise()) soup.points.emplace_back(p.x(), p.y(), p.z());
  for (const auto& t : mesh.triangles.colwise()) {
    soup.triangles.push_back({std::size_t(t[0]), std::size_t(t[1]), std::size_t(t[2])});
  }
  processing::repair_polygon_soup(soup.points, soup.triangles);
  std::erase_if(soup.triangles, [](const auto& triangle) { return triangle.size() != 3; });
  if (soup.triangles.empty()) {
    throw InputError("Loop subdivision needs triangles of three different corners, got none");
  }
  return soup;
}

struct Edges {
  std::size_t count = 0;
  std::size_t crowded = 0;  ///< Of more than two triangles.
  std::pair<Point, Point> firstCrowded;
};

Edges countEdges(const Soup& soup) {
  std::vector<std::pair<std::size_t, std::size_t>> edges;
  for (const auto& triangle : soup.triangles) {
    for (int corner = 0; corner < 3; ++corner) {
      edges.emplace_back(std::minmax({triangle[corner], triangle[(corner + 1) % 3]}));
    }
  }
  std::sort(edges.begin(), edges.end());
  Edges counted;
  for (auto edge = edges.begin(); edge != edges.end(); ++counted.count) {
    const auto next = std::upper_bound(edge, edges.end(), *edge);
    if (next - edge > 2 && counted.crowded++ == 0) {
      counted.firstCrowded = {soup.points[edge->first], soup.points[edge->second]};
    }
    edge = next;
  }
  return counted;
}

std::vector<std::string> noticesOn(const Edges& edges) {
  if (edges.crowded == 0) return {};
  const auto& [a, b] = edges.firstCrowded;
  return {
      fmt::format("cut open before Loop subdivision along {} of more than two triangles, the first "
                  "from [{}, {}, {}] to [{}, {}, {}]",
                  countOf(edges.crowded, "edge"), a.x(), a.y(), a.z(), b.x(), b.y(), b.z())};
}

/// Vertices at which sheets touch, along edges too, are split; so is a mesh of one side alone.
HalfedgeMesh toHalfedges(Soup soup, const Edges& edges) {
  processing::orient_polygon_soup(soup.points, soup.triangles);
  HalfedgeMesh mesh;
  processing::polygon_soup_to_polygon_mesh(soup.points, soup.triangles, mesh);
  if (edges.crowded == 0 && mesh.number_of_edges() != edges.count) {
    throw InputError(
        "Loop subdivision needs a mesh of two sides, got one that cannot be oriented, like a "
        "Moebius strip");
  }
  return mesh;
}

TriangleMesh toTriangles(const HalfedgeMesh& halfedges) {
  TriangleMesh mesh{Eigen::Matrix3Xd(3, halfedges.number_of_vertices()),
                    Eigen::Matrix3Xi(3, halfedges.number_of_faces())};
  for (const auto vertex : halfedges.vertices()) {
    const Point& p = halfedges.point(vertex);
    mesh.vertices.col(vertex.idx()) << p.x(), p.y(), p.z();
  }
  for (const auto face : halfedges.faces()) {
    int corner = 0;
    for (const auto vertex : halfedges.vertices_around_face(halfedges.halfedge(face))) {
      mesh.triangles(corner++, face.idx()) = static_cast<int>(vertex.idx());
    }
  }
  return mesh;
}

void checkTriangleCount(double triangles, int rounds) {
  for (int round = 0; round < rounds && triangles <= kMostSubdividedTriangles; ++round) {
    triangles *= 4;
  }
  if (triangles <= kMostSubdividedTriangles) return;
  throw InputError(
      fmt::format("{} rounds of Loop subdivision make too many triangles: at most {} are possible",
                  rounds, kMostSubdividedTriangles));
}

}  // namespace

NotedMesh subdivideLoop(const TriangleMesh& mesh, int rounds) {
  if (rounds == 0) return {mesh, {}};
  checkTriangleCount(static_cast<double>(mesh.triangles.cols()), rounds);
  Soup soup = soupOf(joinVertices(mesh));
  const Edges edges = countEdges(soup);
  HalfedgeMesh halfedges = toHalfedges(std::move(soup), edges);
  CGAL::Subdivision_method_3::Loop_subdivision(halfedges,
                                               CGAL::parameters::number_of_iterations(rounds));
  NotedMesh subdivided{toTriangles(halfedges), noticesOn(edges)};
  if (!subdivided.mesh.vertices.allFinite()) {
    throw InputError(fmt::format("Loop subdivision overflows: coordinates are too large, up to {}",
                                 mesh.vertices.cwiseAbs().maxCoeff()));
  }
  return subdivided;
}

}  // namespace morphgrid
