#include "core/nearest_name.h"

#include <gtest/gtest.h>

namespace morphgrid {
namespace {

TEST(EditDistance, CountsEdits) {
  EXPECT_EQ(editDistance("", ""), 0);
  EXPECT_EQ(editDistance("", "abc"), 3);
  EXPECT_EQ(editDistance("layers", "layers"), 0);
  EXPECT_EQ(editDistance("layers", "layer"), 1);
  EXPECT_EQ(editDistance("layers", "lbyers"), 1);
  EXPECT_EQ(editDistance("layers", "alyers"), 1);
  EXPECT_EQ(editDistance("kitten", "sitting"), 3);
}

TEST(NearestName, TakesTheNearest) {
  EXPECT_EQ(nearestName("nodes_w", {"layers", "nodes_u", "nodes_v"}), "nodes_u");
  EXPECT_EQ(nearestName("nodes_long_", {"nodes", "nodes_long"}), "nodes_long");
  EXPECT_EQ(nearestName("kin", {"kind"}), "kind");
}

TEST(NearestName, GivesUpWhereTooMuchDiffers) {
  EXPECT_EQ(nearestName("tau", {"layers", "layer_spacing"}), std::nullopt);
  EXPECT_EQ(nearestName("", {"layers"}), std::nullopt);
  EXPECT_EQ(nearestName("layers", {}), std::nullopt);
  EXPECT_EQ(nearestName(std::string(100000, 'a'), {std::string(100000, 'a')}), std::nullopt);
}

}  // namespace
}  // namespace morphgrid
