#include "app/activity_line.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace morphgrid {
namespace {

std::string toldIn(std::chrono::milliseconds time, bool quiet) {
  testing::internal::CaptureStderr();
  {
    const ActivityLine activity("measuring", quiet);
    std::this_thread::sleep_for(time);
  }
  return testing::internal::GetCapturedStderr();
}

constexpr std::chrono::milliseconds kMoreThanASecond(1300);

TEST(ActivityLine, IsToldAfterASecond) {
  EXPECT_THAT(toldIn(kMoreThanASecond, false), testing::HasSubstr("measuring: 1 s so far"));
}

TEST(ActivityLine, IsNotToldWhereNobodyWaits) {
  EXPECT_EQ(toldIn(std::chrono::milliseconds(1), false), "");
}

TEST(ActivityLine, IsNotToldToThoseWhoWantQuiet) { EXPECT_EQ(toldIn(kMoreThanASecond, true), ""); }

}  // namespace
}  // namespace morphgrid
