#pragma once
#include <memory>
#include <optional>
#include <string>

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
};

}  // namespace morphgrid
