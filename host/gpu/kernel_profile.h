#pragma once
#include <map>
#include <string>

namespace morphgrid {

/// Where the time of a device's submissions goes, of all its CommandStreams.
class KernelProfile {
 public:
  struct Share {
    long calls = 0;
    double seconds = 0;
  };

  /// Keys are the kernels' names and "copy".
  const std::map<std::string, Share>& kernels() const { return kernels_; }
  /// How long the host waited for them; more than all kernels, for a submission costs time itself.
  const Share& submissions() const { return submissions_; }

  void addCall(const std::string& kernel, double seconds) { add(kernels_[kernel], seconds); }
  void addSubmission(double seconds) { add(submissions_, seconds); }
  void clear() { *this = {}; }

 private:
  static void add(Share& share, double seconds) {
    ++share.calls;
    share.seconds += seconds;
  }

  std::map<std::string, Share> kernels_;
  Share submissions_;
};

}  // namespace morphgrid
