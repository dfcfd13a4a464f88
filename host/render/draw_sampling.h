#pragma once
#include "gpu/device.h"
#include "render/camera.h"
#include "render/image.h"
#include "surface/mesh_ray_caster.h"

namespace morphgrid {

/// How rays sampled a mesh, on white: the mesh in grey, the Catmull-Rom splines through the hits
/// along u in red and along v in blue, the hits where drawn splines cross as dark balls. Of many
/// rays every n-th isoline is drawn, up to about 40 each way, and the last one. Missed rays
/// interrupt the splines and are marked in orange, at the middle depth of the hits, in front of
/// everything; of many rays one mark stands for neighbours.
/// width, height > 0 in pixels; samples of a pixel, where the device has them: 1 or 4. Throws
/// DeviceError when the device fails or the mesh exceeds its limits.
Image drawSampling(const Device& device, const TriangleMesh& mesh, const RayHits& hits,
                   const Camera& camera, int width, int height, int samples = 4);

}  // namespace morphgrid
