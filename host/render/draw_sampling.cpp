#include "render/draw_sampling.h"

#include <fmt/format.h>

#include <glm/gtc/matrix_transform.hpp>

#include "core/error.h"
#include "gpu/graphics_pipeline.h"
#include "gpu/offscreen_target.h"
#include "render/ball_vert.h"
#include "render/local_view.h"
#include "render/mesh_frag.h"
#include "render/mesh_vert.h"
#include "render/round_frag.h"
#include "render/sampling_layout.h"
#include "render/spline_vert.h"
#include "shared/render_types.h"

namespace morphgrid {
namespace {

constexpr int kFewestPieces = 400;         // A spline of as many pieces looks smooth.
constexpr double kLineHalfWidth = 0.0016;  // Shares of the sampled box's diagonal.
constexpr double kBallRadius = 0.0055;
constexpr double kLinePerCell = 0.06;  // The largest half width and radius, in drawn cells.
constexpr double kBallPerCell = 0.17;
constexpr double kLiftPerStep = 0.5;  // In distances of the rays: the mesh bulges between them.

/// Local coordinates, see SamplingPush.
struct LocalFrame {
  Eigen::Vector3d origin;
  double unit;

  explicit LocalFrame(const SamplingLayout& layout)
      : origin(layout.sampled.center()), unit(layout.sampled.diagonal().norm()) {}

  glm::dmat4 worldFromLocal() const {
    const glm::dmat4 moved = glm::translate(glm::dmat4(1), {origin.x(), origin.y(), origin.z()});
    return glm::scale(moved, glm::dvec3(unit));
  }
  Eigen::Matrix3Xf toLocal(const Eigen::Matrix3Xd& points) const {
    return ((points.colwise() - origin) / unit).cast<float>();
  }
};

Eigen::Matrix4Xf localHits(const LocalFrame& frame, const RayHits& hits) {
  Eigen::Matrix4Xf rays(4, hits.points.cols());
  rays.topRows<3>() = frame.toLocal(hits.points);
  rays.row(3) =
      Eigen::Map<const Eigen::RowVectorX<char>>(hits.hit.data(), rays.cols()).cast<float>();
  return rays;
}

Eigen::Matrix4Xf localBalls(const LocalFrame& frame, const SamplingLayout& layout,
                            const RayHits& hits) {
  const Eigen::Matrix3Xf points = frame.toLocal(crossingHits(layout, hits));
  const Eigen::Matrix3Xf marks = frame.toLocal(missedMarks(layout, hits));
  Eigen::Matrix4Xf balls(4, points.cols() + marks.cols());
  balls.leftCols(points.cols()) = points.colwise().homogeneous();
  balls.rightCols(marks.cols()).topRows<3>() = marks;
  balls.rightCols(marks.cols()).row(3).setZero();
  return balls;
}

/// columns: of 3 or 4 numbers of four bytes; `what` names them where they are too many.
template <typename Columns>
Buffer uploadColumns(const Device& device, const Columns& columns, const char* what) {
  const std::uint64_t bytes = columns.size() * sizeof(columns(0, 0));
  const std::uint64_t limit = device.limits().maxStorageBufferRange;
  if (bytes > limit) {
    throw DeviceError(fmt::format(
        "device {} draws at most {} {} of a mesh, got {}; use a coarser one, or pictures = false",
        device.name(), limit / (columns.rows() * sizeof(columns(0, 0))), what, columns.cols()));
  }
  Buffer buffer(device, bytes, BufferUsage::storageBuffer | BufferUsage::transferDst,
                MemoryKind::device);
  uploadBytes(device, buffer, columns.data(), bytes);
  return buffer;
}

SamplingPush commonPush(const LocalView& view, const SamplingLayout& layout) {
  SamplingPush push{};
  push.clipFromLocal = view.clipFromLocal;
  push.eye = view.eye;
  push.pixelSize = view.pixelSize;
  push.towardsLight = view.towardsLight;
  push.countU = layout.columns.rays;
  push.countV = layout.rows.rays;
  push.strideU = layout.columns.stride;
  push.strideV = layout.rows.stride;
  return push;
}

/// Splines along u (direction 0) or v (1), `rays` hits each.
SamplingPush splinePush(SamplingPush push, const SamplingLayout& layout, int direction, int rays) {
  const double unit = layout.sampled.diagonal().norm();
  push.radius = static_cast<float>(std::min(kLineHalfWidth, kLinePerCell * layout.cell / unit));
  push.lift = static_cast<float>(kLiftPerStep * layout.rayStep / unit) + push.radius;
  push.direction = direction;
  push.refine = 1 + (kFewestPieces - 1) / (rays - 1);
  return push;
}

/// Balls lie in front of the splines.
SamplingPush ballPush(SamplingPush push, const SamplingLayout& layout) {
  const double unit = layout.sampled.diagonal().norm();
  push.radius = static_cast<float>(std::min(kBallRadius, kBallPerCell * layout.cell / unit));
  push.lift = static_cast<float>(kLiftPerStep * layout.rayStep / unit) + 2 * push.radius;
  return push;
}

Eigen::Index splineVertices(const SamplingPush& push, int isolines, int rays) {
  return Eigen::Index{kVerticesPerQuad} * isolines * (rays - 1) * push.refine;
}

}  // namespace

SamplingDrawing::SamplingDrawing(const Device& device, const TriangleMesh& mesh,
                                 const RayHits& hits, const DrawPass& pass)
    : layout_(layOutSampling(mesh, hits)),
      meshVertices_(mesh.triangles.size()),
      raysU_(hits.countU),
      raysV_(hits.countV),
      vertices_(uploadColumns(device, LocalFrame(layout_).toLocal(mesh.vertices), "vertices")),
      triangles_(uploadColumns(device, mesh.triangles, "triangles")),
      rays_(uploadColumns(device, localHits(LocalFrame(layout_), hits), "rays")),
      balls_(uploadColumns(device, localBalls(LocalFrame(layout_), layout_, hits), "rays")),
      mesh_(device, {mesh_vert_spirv, mesh_frag_spirv},
            {{kBindingMeshVertices, &vertices_}, {kBindingMeshTriangles, &triangles_}}, pass),
      splines_(device, {spline_vert_spirv, round_frag_spirv}, {{kBindingRayHits, &rays_}}, pass),
      ballLayer_(device, {ball_vert_spirv, round_frag_spirv}, {{kBindingBalls, &balls_}}, pass) {}

SamplingDrawing::Layer::Layer(const Device& device, const ShaderPair& shaders,
                              const std::vector<KernelResource>& buffers, const DrawPass& pass)
    : pipeline(device, shaders, slotsOf(buffers), sizeof(SamplingPush), pass),
      resources(device, pipeline.resourceLayout(), buffers) {}

void SamplingDrawing::Layer::draw(const CommandBuffer& commands, const SamplingPush& push,
                                  Eigen::Index vertexCount) const {
  pipeline.bind(commands, resources);
  pipeline.draw(commands, push, static_cast<uint>(vertexCount));
}

void SamplingDrawing::draw(const CommandBuffer& commands, const Camera& camera,
                           int imageHeight) const {
  const LocalView view = localView(LocalFrame(layout_).worldFromLocal(), camera, imageHeight);
  const SamplingPush push = commonPush(view, layout_);
  const SamplingPush alongU = splinePush(push, layout_, 0, raysU_);
  const SamplingPush alongV = splinePush(push, layout_, 1, raysV_);
  mesh_.draw(commands, push, meshVertices_);
  splines_.draw(commands, alongU, splineVertices(alongU, layout_.rows.count, raysU_));
  splines_.draw(commands, alongV, splineVertices(alongV, layout_.columns.count, raysV_));
  const auto ballCount = static_cast<Eigen::Index>(balls_.bytes() / sizeof(glm::vec4));
  ballLayer_.draw(commands, ballPush(push, layout_), kVerticesPerDisc * ballCount);
}

Image drawSampling(const Device& device, const TriangleMesh& mesh, const RayHits& hits,
                   const Camera& camera, int width, int height, int samples) {
  OffscreenTarget target(device, static_cast<uint>(width), static_cast<uint>(height),
                         static_cast<uint>(samples));
  const SamplingDrawing drawing(device, mesh, hits, target.pass());
  return {width, height, target.render([&](const CommandBuffer& commands) {
            drawing.draw(commands, camera, height);
          })};
}

}  // namespace morphgrid
