#pragma once
#include <exception>
#include <functional>
#include <utility>

namespace morphgrid {

/// Ends work whose result nobody waits for any more. No error.
class Cancelled : public std::exception {
 public:
  const char* what() const noexcept override { return "cancelled"; }
};

/// How long work learns that it is to stop: it asks often enough to end well within a second.
class Cancellation {
 public:
  /// Never requested.
  Cancellation() = default;
  /// isRequested: several threads may call it at once.
  explicit Cancellation(std::function<bool()> isRequested) : isRequested_(std::move(isRequested)) {}

  /// Throws Cancelled once it is requested.
  void check() const {
    if (isRequested_ && isRequested_()) {
      throw Cancelled();
    }
  }

 private:
  std::function<bool()> isRequested_;
};

}  // namespace morphgrid
