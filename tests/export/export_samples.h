#pragma once
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/types.h>

#include <filesystem>
#include <string>

#include "core/read_file.h"
#include "grid/joint_rotations.h"
#include "grid/strut_grid.h"
#include "grid/surface_mesh.h"
#include "tests/support/temporary_folder.h"

namespace morphgrid {

/// While it lives, root is somebody whom permissions stop.
class OrdinaryUser {
 public:
  OrdinaryUser();
  ~OrdinaryUser();
  OrdinaryUser(const OrdinaryUser&) = delete;
  OrdinaryUser& operator=(const OrdinaryUser&) = delete;

 private:
  uid_t before_;
};

/// While it lives, no file can grow beyond `bytes`.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes);
  ~FullDisk();
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

 private:
  rlimit before_;
  void (*handlerBefore_)(int);
};

void writeFile(const std::filesystem::path& path, const std::string& content);

/// A grid, where it ended, and its surface: no two numbers alike, most with all their digits.
struct ExportSample {
  StrutGrid grid;
  Eigen::Matrix3Xd positions;
  SurfaceMesh surface;
};
ExportSample exportSample(const GridShape& shape);

/// Width and height of the bars of a frameSample().
inline constexpr double kBarWidth = 0.11;
inline constexpr double kBarHeight = 0.07;

/// The same of bars that are welded to joints, which have turned and moved; printed as square cells
/// of side 1.
struct FrameSample : ExportSample {
  JointRotations rotations;
};
FrameSample frameSample(const GridShape& shape);

/// The smallest grid, and others whose sides differ.
inline const GridShape kSampleShapes[] = {{2, 2, 1}, {5, 3, 2}, {2, 7, 3}};

/// A test's name for its shape, e.g. "5x3x2".
std::string shapeName(const testing::TestParamInfo<GridShape>& test);

}  // namespace morphgrid
