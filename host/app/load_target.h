#pragma once
#include <memory>

#include "app/scene.h"
#include "target/target.h"

namespace morphgrid {

/// Loads and surveys the surface that a scene asks for; null for one that is given by bend angles.
/// Throws InputError when it cannot be had, Cancelled where that is requested.
std::shared_ptr<const Target> loadTarget(const Scene& scene, const Cancellation& cancellation = {});

/// Keeps the last target while what it was loaded from stays.
class TargetKeeper {
 public:
  /// As loadTarget().
  std::shared_ptr<const Target> targetOf(const Scene& scene, const Cancellation& cancellation = {});

 private:
  SurfaceRequest request_;
  std::shared_ptr<const Target> target_;
};

}  // namespace morphgrid
