#pragma once
#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "core/cancellation.h"
#include "surface/mesh_ray_caster.h"

namespace morphgrid {

/// A direction in which rays may look at a mesh, and the rotation that makes it +x.
struct Sight {
  std::string name;  ///< For people: "along -z".
  Eigen::Vector3d axis = Eigen::Vector3d::UnitY();
  double degrees = 0;

  /// As a mesh configuration's `rotate` does it.
  Eigen::Matrix3d rotation() const;
  /// In the mesh's own coordinates, a unit vector.
  Eigen::Vector3d direction() const { return rotation().transpose().col(0); }
};

/// The six axes, against the mean normal of what is open, and the mesh's principal axes, as far as
/// they differ from each other.
std::vector<Sight> listSights(const TriangleMesh& mesh);

/// What is seen in one direction.
struct SightRating {
  Sight sight;
  /// The largest box without holes and steep slopes, of the turned mesh; nothing where there is
  /// none.
  std::optional<SamplingBox> box;
  double share = 0;  ///< Of the mesh's area that lies in the box.
  /// How much of the mesh turns its outside to the rays: 1 for a plate seen from its front, -1 from
  /// behind, 0 for what is closed.
  double facing = 0;
};

/// Looks at the mesh in each direction; the one that sees the most first, of those alike the one
/// that sees the outside. Throws Cancelled where that is requested.
std::vector<SightRating> rateSights(const TriangleMesh& mesh, const std::vector<Sight>& sights,
                                    const Cancellation& cancellation = {});

/// The area of a surface through the hits of a lattice, where all four rays of a cell hit.
double areaBetween(const RayHits& hits);

}  // namespace morphgrid
