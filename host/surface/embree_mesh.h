#pragma once
#include <embree3/rtcore.h>

#include <Eigen/Core>
#include <memory>

namespace morphgrid {

/// A triangle mesh as the only geometry of an Embree scene. Private to this folder.
class EmbreeMesh {
 public:
  /// vertices 3 x n, triangles 3 x m of vertex indices; primitive IDs are the triangles' columns.
  /// quality: of the hierarchy; low is built in a third of the time. Throws std::runtime_error when
  /// Embree runs out of memory.
  EmbreeMesh(const Eigen::Matrix3Xf& vertices, const Eigen::Matrix3Xi& triangles,
             RTCSceneFlags flags, RTCBuildQuality quality);

  RTCScene scene() const { return scene_.get(); }

  /// Calls `visit` with `userData` for the triangles within the radius of a point, which it may
  /// shrink.
  void query(const Eigen::Vector3d& point, float radius, RTCPointQueryFunction visit,
             void* userData) const;

 private:
  void* newBuffer(RTCGeometry geometry, RTCBufferType type, RTCFormat format,
                  Eigen::Index count) const;
  void throwOnError() const;

  std::unique_ptr<RTCDeviceTy, decltype(&rtcReleaseDevice)> device_;
  std::unique_ptr<RTCSceneTy, decltype(&rtcReleaseScene)> scene_;
};

}  // namespace morphgrid
