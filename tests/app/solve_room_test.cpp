#include "app/solve_room.h"

#include <gmock/gmock.h>

#include "solve/solve_memory.h"

namespace morphgrid {
namespace {

using testing::HasSubstr;

constexpr std::uint64_t kPlenty = std::uint64_t{1} << 50;
const SolveRoom kAllRoom{"GPU",  {kPlenty, kPlenty, false}, kPlenty, kPlenty, kPlenty, kPlenty,
                         kPlenty};
const GridShape kShape{301, 201, 3};

std::string complaint(const SolveRoom& room, Method method = Method::multigrid) {
  return whyTooLarge(kShape, method, room).value_or("");
}

TEST(SolveRoom, WhatFitsIsFine) {
  EXPECT_EQ(complaint(kAllRoom), "");
  SolveRoom exact = kAllRoom;
  const SolveMemory needed = multigridMemory(kShape);
  exact.memory = {needed.device, needed.host, false};
  exact.largestBuffer = needed.largestBuffer;
  exact.mostBound = needed.mostBound;
  exact.mostVertices = 301 * 201 * 3;
  exact.mostVerticesU = 301;
  exact.mostVerticesV = 201;
  EXPECT_EQ(complaint(exact), "");
}

TEST(SolveRoom, WhatIsLackingIsNamed) {
  SolveRoom room = kAllRoom;
  room.memory.device = 100'000'000;
  EXPECT_THAT(complaint(room), HasSubstr("memory on GPU, 0.1 GB are free there"));
  EXPECT_EQ(complaint(room, Method::jacobi), "");
  EXPECT_EQ(complaint(room, Method::reference), "");
  room = kAllRoom;
  room.memory.host = 100'000'000;
  EXPECT_THAT(complaint(room), HasSubstr("GB of memory, 0.1 GB are free"));
  room = kAllRoom;
  room.largestBuffer = 2'000'000;
  EXPECT_THAT(complaint(room), HasSubstr("GPU has them of 0.002 GB at most"));
  room = kAllRoom;
  room.mostBound = 2'000'000;
  EXPECT_THAT(complaint(room), HasSubstr("GPU reaches 0.002 GB at most"));
  room = kAllRoom;
  room.mostVertices = 100'000;
  EXPECT_THAT(complaint(room), HasSubstr("100000 invocations"));
  room = kAllRoom;
  room.mostVerticesV = 200;
  EXPECT_THAT(complaint(room), HasSubstr("x 200 vertices a layer"));
  EXPECT_THAT(complaint(room), HasSubstr("299 x 199 nodes"));
}

TEST(SolveRoom, ADeviceThatIsTheHostSharesItsMemory) {
  const SolveMemory needed = multigridMemory(kShape);
  SolveRoom room = kAllRoom;
  room.memory = {needed.device + needed.host - 1, needed.device + needed.host - 1, true};
  EXPECT_NE(complaint(room), "");
  room.memory.shared = false;
  EXPECT_EQ(complaint(room), "");
}

TEST(SolveRoom, TheLargestSizeThatFitsIsTold) {
  SolveRoom room = kAllRoom;
  room.mostVertices = 16 * 11 * 3;
  EXPECT_THAT(complaint(room),
              HasSubstr("a grid of 300 x 200 nodes in 3 layers (181503 vertices)"));
  EXPECT_THAT(complaint(room),
              HasSubstr("15 x 10 nodes (528 vertices) would fit: set 15 along the longer edge"));
}

TEST(SolveRoom, OfOneLayerAsMuchIsReachedAsOfSeveral) {
  // Its columns' blocks are larger than its vertices, but written in chunks.
  SolveRoom room = kAllRoom;
  room.mostBound = std::uint64_t{128} << 20;
  const GridShape nearlyAll{2896, 2896, 1};
  EXPECT_EQ(whyTooLarge(nearlyAll, Method::multigrid, room), std::nullopt);
  EXPECT_THAT(whyTooLarge({2898, 2898, 1}, Method::multigrid, room).value_or(""),
              HasSubstr("2895 x 2895 nodes (8386816 vertices) would fit"));
  EXPECT_EQ(whyTooLarge({1672, 1672, 3}, Method::multigrid, room), std::nullopt);
}

}  // namespace
}  // namespace morphgrid
