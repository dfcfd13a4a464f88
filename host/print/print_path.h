#pragma once
#include <Eigen/Core>
#include <optional>
#include <vector>

#include "grid/grid_topology.h"
#include "print/bead.h"

namespace morphgrid {

/// What a path lays.
enum class PathKind { along, across, hub, tube, skirt, tag };
inline constexpr std::size_t kPathKinds = 6;

/// What the nozzle lays without stopping. Lengths in mm, from the bed's corner.
struct PrintPath {
  std::vector<Eigen::Vector2d> points;
  PathKind kind = PathKind::along;
  Bead bead{};
  double speed = 0;  ///< mm/s
  double flow = 1;   ///< Volume over that of the bead: lines may be spread or squeezed.
  /// It goes on where the last one ended, or beside it: no need to lift.
  bool joins = false;
  GridPlace place{};      ///< The hub's, or that from which the strut leaves along +u or +v.
  bool isAlongU = false;  ///< Of struts.
  /// Where the nozzle, at this hub already, gets to the path's start without crossing the hole.
  std::optional<Eigen::Vector2d> aroundHub = std::nullopt;
};

/// What lies at one height.
struct PrintPass {
  double z;       ///< Of its upper side.
  double height;  ///< Of the lowest bead in it.
};

/// Takes a tier as the nozzle lays it.
class TierVisitor {
 public:
  virtual ~TierVisitor() = default;
  virtual void beginPass(const PrintPass& pass) = 0;
  /// The path is the visitor's only during the call.
  virtual void lay(const PrintPath& path) = 0;
};

}  // namespace morphgrid
