#include "print/tier_solid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace morphgrid {
namespace {

using Eigen::Vector2d;

constexpr double kFullTurn = 2 * std::numbers::pi;

/// Points in the plane in a row, and where they stand in it.
struct ChainPoint {
  double at;
  int point;
};
using Chain = std::vector<ChainPoint>;

/// A hub's outline. Struts leave it at angles, and have their ends between two points of it.
struct HubOutline {
  struct Arm {
    double angle;
    int neighbour;            ///< Vertex index.
    std::size_t first, last;  ///< Of the outline, the points where the strut's sides begin.
  };
  std::vector<Arm> arms;
  Chain ring, hole;  ///< Counter-clockwise by angle; what begins them ends them too.

  const Arm& armTo(int vertex) const {
    return *std::find_if(arms.begin(), arms.end(),
                         [&](const Arm& arm) { return arm.neighbour == vertex; });
  }
};

/// The plane is cut into hubs and struts; they are raised to the heights at which they end. Points
/// of outlines belong to both sides, so that the whole is closed.
class SolidBuilder {
 public:
  SolidBuilder(const PrintPlan& plan, int tier) : plan_(plan), tier_(tier) {
    const PrintHeights& heights = plan.heights;
    levels_ = {0, heights.strut, heights.strut + heights.tube};
    hubTop_ = tier + 1 < plan.shape.layers ? 2 : 1;
  }

  SolidMesh build();

 private:
  std::vector<int> neighboursOf(const GridPlace& place) const;
  HubOutline outlineOf(const GridPlace& place);
  void addArc(const Vector2d& hub, double begin, double end, Chain& ring);
  void raiseHub(const HubOutline& hub);
  void raiseStrut(const Strut& strut);
  void coverBetween(const Chain& back, const Chain& front, int top);

  int addPoint(const Vector2d& hub, double radius, double angle);
  int vertex(int point, int level);
  void triangle(int a, int b, int c) { triangles_.emplace_back(a, b, c); }
  void cover(int a, int b, int c, int top);
  void wall(int a, int b, int low, int high);

  const PrintPlan& plan_;
  int tier_;
  std::array<double, 3> levels_;  ///< z of the bed, of the struts' and of the tubes' upper sides.
  int hubTop_;
  std::vector<HubOutline> hubs_;  ///< By column.
  std::vector<Vector2d> plane_;
  std::vector<std::array<int, 3>> vertices_;  ///< Of a point in the plane at each level; or -1.
  std::vector<Eigen::Vector3d> points_;
  std::vector<Eigen::Vector3i> triangles_;
};

std::vector<int> SolidBuilder::neighboursOf(const GridPlace& place) const {
  const GridShape& shape = plan_.shape;
  const int own = shape.index(place);
  std::vector<int> neighbours;
  if (place.i > 0) neighbours.push_back(own - 1);
  if (place.i < shape.cellsU()) neighbours.push_back(own + 1);
  if (place.j > 0) neighbours.push_back(own - shape.verticesU);
  if (place.j < shape.cellsV()) neighbours.push_back(own + shape.verticesU);
  return neighbours;
}

int SolidBuilder::addPoint(const Vector2d& hub, double radius, double angle) {
  plane_.push_back(hub + radius * Vector2d(std::cos(angle), std::sin(angle)));
  vertices_.push_back({-1, -1, -1});
  return static_cast<int>(plane_.size()) - 1;
}

/// From the ring's last point, which is at `begin`.
void SolidBuilder::addArc(const Vector2d& hub, double begin, double end, Chain& ring) {
  const int steps =
      std::max(1, static_cast<int>(std::ceil((end - begin) * kRingSides / kFullTurn - 1e-9)));
  for (int step = 1; step <= steps; ++step) {
    const double angle = begin + step * (end - begin) / steps;
    ring.push_back({angle, addPoint(hub, plan_.hub.diameter / 2, angle)});
  }
}

HubOutline SolidBuilder::outlineOf(const GridPlace& place) {
  const Vector2d hub = plan_.at(place);
  HubOutline outline;
  for (const int neighbour : neighboursOf(place)) {
    const Vector2d to = plan_.positions.col(neighbour) - hub;
    outline.arms.push_back({std::atan2(to.y(), to.x()), neighbour, 0, 0});
  }
  std::sort(outline.arms.begin(), outline.arms.end(),
            [](const auto& a, const auto& b) { return a.angle < b.angle; });
  const double half = std::asin(plan_.strutWidth() / plan_.hub.diameter);
  const double begin = outline.arms.front().angle - half;
  outline.ring.push_back({begin, addPoint(hub, plan_.hub.diameter / 2, begin)});
  for (std::size_t n = 0; n < outline.arms.size(); ++n) {
    HubOutline::Arm& arm = outline.arms[n];
    const bool isLast = n + 1 == outline.arms.size();
    arm.first = outline.ring.size() - 1;
    addArc(hub, arm.angle - half, arm.angle + half, outline.ring);
    arm.last = outline.ring.size() - 1;
    addArc(hub, arm.angle + half, isLast ? begin + kFullTurn : outline.arms[n + 1].angle - half,
           outline.ring);
  }
  outline.ring.back().point = outline.ring.front().point;
  const double corners = plan_.hub.hole / 2 / std::cos(kFullTurn / 2 / kRingSides);
  for (int n = 0; n < kRingSides; ++n) {
    const double angle = begin + kFullTurn * n / kRingSides;
    outline.hole.push_back({angle, addPoint(hub, corners, angle)});
  }
  outline.hole.push_back({begin + kFullTurn, outline.hole.front().point});
  return outline;
}

int SolidBuilder::vertex(int point, int level) {
  int& index = vertices_[point][level];
  if (index < 0) {
    index = static_cast<int>(points_.size());
    points_.emplace_back(plane_[point].x(), plane_[point].y(), levels_[level]);
  }
  return index;
}

/// The upper and the lower side over a triangle of the plane.
void SolidBuilder::cover(int a, int b, int c, int top) {
  triangle(vertex(a, top), vertex(b, top), vertex(c, top));
  triangle(vertex(a, 0), vertex(c, 0), vertex(b, 0));
}

/// Of what lies to the left of a line from a to b.
void SolidBuilder::wall(int a, int b, int low, int high) {
  for (int level = low; level < high; ++level) {
    triangle(vertex(a, level), vertex(b, level), vertex(b, level + 1));
    triangle(vertex(a, level), vertex(b, level + 1), vertex(a, level + 1));
  }
}

/// What lies between two chains; the front one to the right of the back one.
void SolidBuilder::coverBetween(const Chain& back, const Chain& front, int top) {
  std::size_t i = 0;
  std::size_t j = 0;
  while (i + 1 < back.size() || j + 1 < front.size()) {
    const bool movesFront =
        i + 1 == back.size() || (j + 1 < front.size() && front[j + 1].at <= back[i + 1].at);
    const int next = movesFront ? front[++j].point : back[i + 1].point;
    cover(back[i].point, movesFront ? front[j - 1].point : front[j].point, next, top);
    if (!movesFront) ++i;
  }
}

void SolidBuilder::raiseHub(const HubOutline& hub) {
  coverBetween(hub.hole, hub.ring, hubTop_);
  for (std::size_t n = 0; n + 1 < hub.hole.size(); ++n) {
    wall(hub.hole[n + 1].point, hub.hole[n].point, 0, hubTop_);
  }
  for (std::size_t n = 0; n + 1 < hub.ring.size(); ++n) {
    const bool meetsStrut = std::any_of(hub.arms.begin(), hub.arms.end(), [&](const auto& arm) {
      return n >= arm.first && n < arm.last;
    });
    wall(hub.ring[n].point, hub.ring[n + 1].point, meetsStrut ? 1 : 0, hubTop_);
  }
}

void SolidBuilder::raiseStrut(const Strut& strut) {
  const HubOutline& from = hubs_[plan_.shape.column(strut.from)];
  const HubOutline& to = hubs_[plan_.shape.column(strut.to)];
  const HubOutline::Arm& out = from.armTo(strut.to);
  const HubOutline::Arm& in = to.armTo(strut.from);
  Chain back, front;  // Both from the strut's right to its left.
  for (std::size_t n = out.first; n <= out.last; ++n) {
    back.push_back({std::sin(from.ring[n].at - out.angle), from.ring[n].point});
  }
  for (std::size_t n = in.last + 1; n-- > in.first;) {
    front.push_back({std::sin(in.angle - to.ring[n].at), to.ring[n].point});
  }
  coverBetween(back, front, 1);
  wall(back.front().point, front.front().point, 0, 1);
  wall(front.back().point, back.back().point, 0, 1);
}

SolidMesh SolidBuilder::build() {
  const GridShape& shape = plan_.shape;
  forEachVertex(shape.layer(), [&](const GridPlace& place) {
    hubs_.push_back(outlineOf({place.i, place.j, tier_}));
  });
  for (const HubOutline& hub : hubs_) raiseHub(hub);
  forEachLateralStrut(shape, [&](const Strut& strut) {
    if (strut.layer == tier_) raiseStrut(strut);
  });
  SolidMesh mesh;
  mesh.points.resize(3, points_.size());
  for (std::size_t n = 0; n < points_.size(); ++n) mesh.points.col(n) = points_[n];
  mesh.triangles.resize(3, triangles_.size());
  for (std::size_t n = 0; n < triangles_.size(); ++n) mesh.triangles.col(n) = triangles_[n];
  return mesh;
}

}  // namespace

SolidMesh tierSolid(const PrintPlan& plan, int tier) { return SolidBuilder(plan, tier).build(); }

}  // namespace morphgrid
