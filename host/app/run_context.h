#pragma once
#include <chrono>
#include <memory>
#include <optional>
#include <string>

#include "app/design_scene.h"
#include "app/pictures.h"
#include "app/solver_keeper.h"
#include "core/error.h"
#include "gpu/device_failure.h"

namespace morphgrid {

struct Stage;

/// The device and the pictures of a run; a run on the CPU without pictures needs neither. Once the
/// device has failed, it is left alone.
struct RunContext {
  std::shared_ptr<Device> device;
  std::unique_ptr<Pictures> pictures;
  std::optional<std::string> failure;  ///< What the device said when it failed.
  std::chrono::steady_clock::time_point begun = std::chrono::steady_clock::now();  ///< The run.
  /// Called with each stage before it is solved; may be empty.
  std::function<void(const Stage&)> onStage;
  /// Told before inverse design checks how its design morphs from flat, on the device grid of the
  /// stage, where the design has come to rest now; may be empty.
  std::function<void(const StrutGrid& chosen)> onCheckFromFlat;
  /// Solvers that runs before this one made; null: each stage makes a solver for itself.
  SolverKeeper* solvers = nullptr;
  /// Multigrid starts a stage of as many vertices from here: where a like scene's came to rest. 3 x
  /// vertexCount, in the plane and in space.
  Eigen::Matrix3Xd nearInPlane, nearFull;

  /// The device must be there.
  std::shared_ptr<MultigridSolver> solverFor(const StrutGrid& grid) const {
    return solvers ? solvers->solverFor(*device, grid)
                   : std::make_shared<MultigridSolver>(*device, grid);
  }

  /// Does what the device may fail at.
  template <typename Work>
  void attempt(const Work& work) {
    try {
      if (!failure) {
        work();
      }
    } catch (const DeviceError& error) {
      failure = error.what();
    } catch (const std::system_error& error) {
      if (!isDeviceFailure(error)) {
        throw;
      }
      failure = error.what();
    }
  }

  /// Draws, if there are to be pictures.
  template <typename Draw>
  void draw(const Draw& work) {
    if (pictures) {
      attempt([&] { work(*pictures); });
    }
  }

  /// Throws DeviceError when the validation layers complained, unless the device failed anyway.
  void requireSilence() const;
};

/// On stderr, where kernels take long to compile.
void sayWhenCompiling(const Device& device);

/// The device that the scene needs; null: it needs none. Says when it compiles for long, unless
/// quiet. Throws DeviceError when there is none that will do.
std::shared_ptr<Device> deviceFor(const Scene& scene, const DeviceOptions& options, bool quiet);

/// For designScene(): whether the device can hold the scene's grid. Keeps a reference to the scene.
RequireShape roomOn(std::shared_ptr<const Device> device, const Scene& scene);

/// picture: the size of the pictures; show: what becomes of them. device: null where the scene
/// needs none.
RunContext createRunContext(const Scene& scene, const SceneDesign& designed,
                            std::shared_ptr<Device> device, const PictureOptions& picture,
                            ShowPanel show);

}  // namespace morphgrid
