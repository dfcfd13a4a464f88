#pragma once
#include <stdexcept>
#include <string>

namespace morphgrid {

/// Bad input: what() holds one problem a line, each beginning with its place (`file:line:column:
/// `).
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The device is missing, lacks something, or failed.
class DeviceError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace morphgrid
