#include "app/load_target.h"

#include "target/mesh_target.h"
#include "target/patch_target.h"

namespace morphgrid {
namespace {

struct TargetLoader {
  const Cancellation& cancellation;

  std::shared_ptr<const Target> operator()(const BendAngleRequest&) const { return nullptr; }
  std::shared_ptr<const Target> operator()(const PatchRequest& request) const {
    return makePatchTarget(request, cancellation);
  }
  std::shared_ptr<const Target> operator()(const MeshRequest& request) const {
    return loadMeshTarget(request, cancellation);
  }
};

}  // namespace

std::shared_ptr<const Target> loadTarget(const Scene& scene, const Cancellation& cancellation) {
  return std::visit(TargetLoader{cancellation}, scene.surface);
}

std::shared_ptr<const Target> TargetKeeper::targetOf(const Scene& scene,
                                                     const Cancellation& cancellation) {
  if (!target_ || request_ != scene.surface || target_->isOutdated()) {
    target_ = loadTarget(scene, cancellation);
    request_ = scene.surface;
  }
  return target_;
}

}  // namespace morphgrid
