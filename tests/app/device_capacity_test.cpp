#include "app/device_capacity.h"

#include <gmock/gmock.h>

#include "solve/solve_memory.h"

namespace morphgrid {
namespace {

using testing::HasSubstr;

constexpr std::uint64_t kPlenty = std::uint64_t{1} << 50;
const DeviceCapacity kUnlimited{
    "GPU", {kPlenty, kPlenty, false}, kPlenty, kPlenty, kPlenty, kPlenty, kPlenty};
const GridShape kShape{301, 201, 3};

std::string complaint(const DeviceCapacity& capacity, const Workload& work = {Method::multigrid}) {
  return explainOverflow(kShape, work, capacity).value_or("");
}

TEST(DeviceCapacity, WhatFitsIsFine) {
  EXPECT_EQ(complaint(kUnlimited), "");
  DeviceCapacity exact = kUnlimited;
  const SolveMemory needed = multigridMemory(kShape);
  exact.memory = {needed.device, needed.host, false};
  exact.largestBuffer = needed.largestBuffer;
  exact.mostBound = needed.mostBound;
  exact.mostVertices = 301 * 201 * 3;
  exact.mostVerticesU = 301;
  exact.mostVerticesV = 201;
  EXPECT_EQ(complaint(exact), "");
}

TEST(DeviceCapacity, WhatIsLackingIsNamed) {
  DeviceCapacity capacity = kUnlimited;
  capacity.memory.device = 100'000'000;
  EXPECT_THAT(complaint(capacity), HasSubstr("memory on GPU, 0.1 GB are free there"));
  capacity.memory.device = jacobiMemory(kShape).device;
  EXPECT_THAT(complaint(capacity), HasSubstr("memory on GPU"));
  EXPECT_EQ(complaint(capacity, {Method::jacobi}), "");
  EXPECT_EQ(complaint(capacity, {Method::reference}), "");
  capacity = kUnlimited;
  capacity.memory.host = 100'000'000;
  EXPECT_THAT(complaint(capacity), HasSubstr("GB of memory, 0.1 GB are free"));
  capacity = kUnlimited;
  capacity.largestBuffer = 2'000'000;
  EXPECT_THAT(complaint(capacity), HasSubstr("GPU has them of 0.002 GB at most"));
  capacity = kUnlimited;
  capacity.mostBound = 2'000'000;
  EXPECT_THAT(complaint(capacity), HasSubstr("GPU reaches 0.002 GB at most"));
  capacity = kUnlimited;
  capacity.mostVertices = 100'000;
  EXPECT_THAT(complaint(capacity), HasSubstr("100000 invocations"));
  capacity = kUnlimited;
  capacity.mostVerticesV = 200;
  EXPECT_THAT(complaint(capacity), HasSubstr("x 200 vertices a layer"));
  EXPECT_THAT(complaint(capacity), HasSubstr("299 x 199 nodes"));
}

TEST(DeviceCapacity, InverseDesignNeedsMore) {
  DeviceCapacity capacity = kUnlimited;
  const SolveMemory forSolve = multigridMemory(kShape);
  capacity.memory = {forSolve.device, kPlenty, false};
  EXPECT_EQ(complaint(capacity), "");
  EXPECT_THAT(complaint(capacity, {Method::multigrid, true}), HasSubstr("GB of memory on GPU"));
  capacity.memory = {kPlenty, forSolve.host, false};
  EXPECT_EQ(complaint(capacity), "");
  EXPECT_THAT(complaint(capacity, {Method::multigrid, true}), HasSubstr("GB of memory, "));
}

TEST(DeviceCapacity, ADeviceThatIsTheHostSharesItsMemory) {
  const SolveMemory needed = multigridMemory(kShape);
  DeviceCapacity capacity = kUnlimited;
  capacity.memory = {needed.device + needed.host - 1, needed.device + needed.host - 1, true};
  EXPECT_NE(complaint(capacity), "");
  capacity.memory.shared = false;
  EXPECT_EQ(complaint(capacity), "");
}

TEST(DeviceCapacity, TheLargestSizeThatFitsIsTold) {
  DeviceCapacity capacity = kUnlimited;
  capacity.mostVertices = 16 * 11 * 3;
  EXPECT_THAT(complaint(capacity),
              HasSubstr("a grid of 300 x 200 nodes in 3 layers (181503 vertices)"));
  EXPECT_THAT(complaint(capacity),
              HasSubstr("15 x 10 nodes (528 vertices) would fit: set 15 along the longer edge"));
}

TEST(DeviceCapacity, OfOneLayerAsMuchIsReachedAsOfSeveral) {
  // Its columns' blocks are larger than its vertices, but written in chunks.
  DeviceCapacity capacity = kUnlimited;
  capacity.mostBound = std::uint64_t{128} << 20;
  const GridShape nearlyAll{2896, 2896, 1};
  EXPECT_EQ(explainOverflow(nearlyAll, {Method::multigrid}, capacity), std::nullopt);
  EXPECT_THAT(explainOverflow({2898, 2898, 1}, {Method::multigrid}, capacity).value_or(""),
              HasSubstr("2895 x 2895 nodes (8386816 vertices) would fit"));
  EXPECT_EQ(explainOverflow({1672, 1672, 3}, {Method::multigrid}, capacity), std::nullopt);
}

}  // namespace
}  // namespace morphgrid
