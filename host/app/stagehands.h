#pragma once
#include <memory>
#include <optional>
#include <string>

#include "app/design_scene.h"
#include "app/pictures.h"
#include "core/error.h"

namespace morphgrid {

/// The device and the pictures of a run; a run on the CPU without pictures needs neither. Once the
/// device has failed, it is left alone.
struct Stagehands {
  std::unique_ptr<Device> device;
  std::unique_ptr<Pictures> pictures;
  std::optional<std::string> failure;  ///< What the device said when it failed.

  /// Does what the device may fail at.
  template <typename Work>
  void attempt(const Work& work) {
    try {
      if (!failure) {
        work();
      }
    } catch (const DeviceError& error) {
      failure = error.what();
    } catch (const vk::SystemError& error) {
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

/// Those that the scene needs. picture: the size of the pictures; show: what becomes of them.
/// Throws DeviceError when there is no device that will do, InputError when it has no room for the
/// grid.
Stagehands summonStagehands(const Scene& scene, const SceneDesign& designed,
                            const DeviceOptions& device, const PictureOptions& picture,
                            ShowPanel show);

}  // namespace morphgrid
