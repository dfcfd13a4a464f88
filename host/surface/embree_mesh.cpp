#include "surface/embree_mesh.h"

#include <fmt/format.h>

#include <new>
#include <stdexcept>

namespace morphgrid {

EmbreeMesh::EmbreeMesh(const Eigen::Matrix3Xf& vertices, const Eigen::Matrix3Xi& triangles,
                       RTCSceneFlags flags, RTCBuildQuality quality)
    : device_(rtcNewDevice(nullptr), rtcReleaseDevice), scene_(nullptr, rtcReleaseScene) {
  throwOnError();
  scene_.reset(rtcNewScene(device_.get()));
  rtcSetSceneFlags(scene_.get(), flags);
  rtcSetSceneBuildQuality(scene_.get(), quality);
  const std::unique_ptr<RTCGeometryTy, decltype(&rtcReleaseGeometry)> geometry(
      rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE), rtcReleaseGeometry);
  throwOnError();
  Eigen::Map<Eigen::Matrix3Xf>(static_cast<float*>(newBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX,
                                                             RTC_FORMAT_FLOAT3, vertices.cols())),
                               3, vertices.cols()) = vertices;
  Eigen::Map<Eigen::Matrix3Xi>(static_cast<int*>(newBuffer(geometry.get(), RTC_BUFFER_TYPE_INDEX,
                                                           RTC_FORMAT_UINT3, triangles.cols())),
                               3, triangles.cols()) = triangles;
  rtcCommitGeometry(geometry.get());
  rtcAttachGeometry(scene_.get(), geometry.get());
  rtcCommitScene(scene_.get());
  throwOnError();
}

void* EmbreeMesh::newBuffer(RTCGeometry geometry, RTCBufferType type, RTCFormat format,
                            Eigen::Index count) const {
  void* buffer = rtcSetNewGeometryBuffer(geometry, type, 0, format, 3 * sizeof(float),
                                         static_cast<std::size_t>(count));
  throwOnError();
  return buffer;
}

void EmbreeMesh::throwOnError() const {
  const RTCError error = rtcGetDeviceError(device_.get());
  if (error == RTC_ERROR_OUT_OF_MEMORY) throw std::bad_alloc();
  if (error != RTC_ERROR_NONE) {
    throw std::runtime_error(fmt::format("Embree cannot take the mesh: error {}", int(error)));
  }
}

void EmbreeMesh::query(const Eigen::Vector3d& point, float radius, RTCPointQueryFunction visit,
                       void* userData) const {
  RTCPointQueryContext context;
  rtcInitPointQueryContext(&context);
  RTCPointQuery query{};
  query.x = static_cast<float>(point.x());
  query.y = static_cast<float>(point.y());
  query.z = static_cast<float>(point.z());
  query.radius = radius;
  rtcPointQuery(scene_.get(), &query, &context, visit, userData);
}

}  // namespace morphgrid
