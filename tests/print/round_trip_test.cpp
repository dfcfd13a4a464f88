// G-code read back by a reader of its own is the plan.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "core/error.h"
#include "print/write_tier.h"
#include "tests/print/gcode_reader.h"
#include "tests/print/print_samples.h"

namespace morphgrid {
namespace {

using Eigen::Vector2d;
using testing::HasSubstr;

double distanceTo(const GcodeMove& move, const Vector2d& point) {
  const Vector2d along = move.to - move.from;
  const double length = along.squaredNorm();
  const double share =
      length == 0 ? 0 : std::clamp((point - move.from).dot(along) / length, 0.0, 1.0);
  return (move.from + share * along - point).norm();
}

/// What was laid under a name.
struct Laid {
  double length = 0;
  double volume = 0;  ///< mm^3
};

class RoundTrip : public testing::TestWithParam<unsigned> {
 protected:
  RoundTrip() {
    PrintMaterial material = sampleMaterial();
    material.strut.passes = 4;
    plan_ = planPrint("random grid", randomGrid({4, 4, 2}, -0.1, 0.42, GetParam()), samplePrinter(),
                      material, {.scale = 13, .enlargement = 1.0});
    for (int tier = 0; tier < 2; ++tier) {
      gcode_.push_back(writeTier(plan_, tier, false));
      read_.push_back(readGcode(gcode_.back().text));
    }
  }

  std::map<std::string, Laid> laidOf(int tier) const {
    const double area = std::numbers::pi / 4 * std::pow(plan_.printer.filamentDiameter, 2);
    std::map<std::string, Laid> laid;
    for (const GcodeMove& move : read_[tier].laid) {
      laid[move.name].length += move.length();
      laid[move.name].volume += move.filament * area;
    }
    return laid;
  }

  /// Of full beads that the parts laid across are worth: as many lines as along, but for a link a
  /// zone.
  double lengthAcross(double share, double free) const {
    const double width = plan_.printer.lineWidth;
    const double pitch = width - plan_.material.strut.passHeight * (1 - std::numbers::pi / 4);
    const auto worth = [&](double zone) {
      return plan_.material.strut.lines * zone - zone / std::round(zone / pitch);
    };
    if (share == 0) return worth(free + width);
    if (share >= 0.5) return worth((1 - share) * free);
    const double outside = (1 - share) * free / 2;
    const double shift = outside > 1.5 ? 0.4 : 0;
    return worth(outside + width / 2 + shift) + worth(outside + width / 2 - shift);
  }

  /// The least distance of moves to the middle of a hub.
  template <typename Choose>
  double nearestToHubs(const std::vector<GcodeMove>& moves, Choose isChosen) const {
    double least = 1e9;
    for (const GcodeMove& move : moves) {
      if (!isChosen(move)) continue;
      for (int n = 0; n < plan_.shape.layerVertexCount(); ++n) {
        least = std::min(least, distanceTo(move, plan_.positions.col(n)));
      }
    }
    return least;
  }

  PrintPlan plan_;
  std::vector<TierGcode> gcode_;
  std::vector<ReadGcode> read_;
};

TEST_P(RoundTrip, SharesAndVolumesAreThoseOfThePlan) {
  const double width = plan_.printer.lineWidth;
  const double height = plan_.material.strut.passHeight;
  const double area = (width - height) * height + std::numbers::pi / 4 * height * height;
  const double pitch = area / height;
  const int lines = plan_.material.strut.lines;
  const int passes = plan_.material.strut.passes;
  double worstShare = 0, worstBead = 0, worstAcross = 0;
  for (int tier = 0; tier < 2; ++tier) {
    auto laid = laidOf(tier);
    forEachLateralStrut(plan_.shape, [&](const Strut& strut) {
      if (strut.layer != tier) return;
      const GridPlace place = plan_.shape.place(strut.from);
      const std::string name = fmt::format(
          "strut {} {} {} ", strut.direction == Strut::Direction::u ? 'u' : 'v', place.i, place.j);
      const double share = valueAt(plan_.shareAlong, strut);
      const double free = (plan_.positions.col(strut.to) - plan_.positions.col(strut.from)).norm() -
                          plan_.hub.diameter;
      const Laid along = laid[name + "along"];
      const Laid across = laid[name + "across"];
      const int pieces = share == 0 ? 0 : share == 1 || share < 0.5 ? 1 : 2;
      const int inner = share == 0 || share == 1 ? 0 : 2;
      if (pieces > 0) {
        const double zone =
            (along.length / passes - pieces * (lines - 1) * pitch) / lines + inner * width / 4;
        worstShare = std::max(worstShare, std::abs(zone / free - share));
        worstBead = std::max(worstBead, std::abs(along.volume / along.length / area - 1));
      } else {
        EXPECT_EQ(along.length, 0);
      }
      if (share < 1) {
        const double full = passes * area * lengthAcross(share, free);
        worstAcross = std::max(worstAcross, std::abs(across.volume / full - 1));
      }
    });
  }
  EXPECT_LT(worstShare, 0.001);
  EXPECT_LT(worstBead, 0.001);
  EXPECT_LT(worstAcross, 0.001);
}

TEST_P(RoundTrip, RingsHaveTheVolumeOfCircles) {
  const Bead bead{plan_.printer.lineWidth, 2 * plan_.material.strut.passHeight};
  double circles = 0;
  for (const double radius : plan_.hub.ringRadii) circles += 2 * std::numbers::pi * radius;
  const double expected = circles * bead.area() * plan_.material.strut.passes / 2;
  for (int tier = 0; tier < 2; ++tier) {
    auto laid = laidOf(tier);
    forEachVertex(plan_.shape.layer(), [&](const GridPlace& place) {
      EXPECT_NEAR(laid[fmt::format("hub {} {}", place.i, place.j)].volume / expected, 1, 0.001);
    });
  }
}

TEST_P(RoundTrip, TheFilamentIsWhatTheFileSays) {
  for (int tier = 0; tier < 2; ++tier) {
    const ReadGcode& read = read_[tier];
    const double drawnBack = plan_.printer.retraction;  // At the end.
    EXPECT_NEAR(read.filament + drawnBack, read.totals.at("filament used [mm]"), 0.01);
    EXPECT_NEAR(read.filament + drawnBack, gcode_[tier].figures.filamentMm, 0.001);
    EXPECT_NEAR(read.totals.at("filament used [g]"), gcode_[tier].figures.grams, 0.005);
    double laid = 0;
    for (const GcodeMove& move : read.laid) laid += move.type == "Custom" ? 0 : move.length();
    EXPECT_NEAR(laid, gcode_[tier].figures.laidMm(), 1e-3 * laid);
  }
}

TEST_P(RoundTrip, AllOfItIsOnTheBed) {
  for (const ReadGcode& read : read_) {
    for (const GcodeMove& move : read.laid) {
      EXPECT_GE(move.to.minCoeff(), plan_.printer.lineWidth / 2);
      EXPECT_LE(move.to.x(), plan_.printer.bedX - plan_.printer.lineWidth / 2);
      EXPECT_LE(move.to.y(), plan_.printer.bedY - plan_.printer.lineWidth / 2);
    }
  }
}

TEST_P(RoundTrip, NothingIsLaidInAHole) {
  const double nearest = (plan_.hub.hole + plan_.printer.lineWidth) / 2 - 1e-3;  // The digits.
  for (const ReadGcode& read : read_) {
    EXPECT_GE(nearestToHubs(read.laid, [](const GcodeMove&) { return true; }), nearest);
  }
}

TEST_P(RoundTrip, HolesAreCrossedOnlyWithTheFilamentDrawnBack) {
  for (const ReadGcode& read : read_) {
    const auto isAtHand = [](const GcodeMove& move) {
      return !move.isDrawnBack && move.type != "Custom";
    };
    EXPECT_GE(nearestToHubs(read.travels, isAtHand), plan_.hub.hole / 2);
  }
}

TEST_P(RoundTrip, HeightsAreThoseOfThePlan) {
  for (int tier = 0; tier < 2; ++tier) {
    std::set<int> heights;  // Micrometres.
    for (const GcodeMove& move : read_[tier].laid) {
      if (move.type != "Custom") heights.insert(static_cast<int>(std::lround(1000 * move.z)));
    }
    for (int pass = 1; pass <= 4; ++pass) EXPECT_EQ(heights.count(80 * pass), 1u);
    const double top =
        plan_.heights.strut + (tier == 0 ? plan_.heights.tube : 0);  // The top one has no tubes.
    EXPECT_EQ(*heights.rbegin(), std::lround(1000 * top));
    double last = 0;
    for (const GcodeMove& move : read_[tier].laid) {
      if (move.name.rfind("strut", 0) != 0) continue;
      EXPECT_GE(move.z, last);
      last = move.z;
    }
  }
}

TEST_P(RoundTrip, ProgressRunsToTheEnd) {
  for (const ReadGcode& read : read_) {
    EXPECT_LT(read.progress.front(), 5);  // The nozzle has been filled.
    EXPECT_EQ(read.progress.back(), 100);
    EXPECT_TRUE(std::is_sorted(read.progress.begin(), read.progress.end()));
    EXPECT_EQ(read.progress.size(), read.passHeights.size() + 1);
  }
}

INSTANTIATE_TEST_SUITE_P(RandomGrids, RoundTrip, testing::Values(1, 2, 3));

PrintPlan smallPlan(Flavour flavour) {
  Printer printer = samplePrinter();
  printer.flavour = flavour;
  return planPrint("two\ncells; \xff", flatGrid({3, 2, 2}, 0.2), printer, sampleMaterial(),
                   {.scale = 15});
}

TEST(WriteTier, SpeaksThePrintersFlavour) {
  EXPECT_THAT(writeTier(smallPlan(Flavour::marlin), 0, false).text,
              HasSubstr("\nM204 P1000 T2000\n"));
  EXPECT_THAT(writeTier(smallPlan(Flavour::rrf), 0, false).text, HasSubstr("\nM204 P1000 T2000\n"));
  const std::string klipper = writeTier(smallPlan(Flavour::klipper), 0, false).text;
  EXPECT_THAT(klipper, HasSubstr("\nM204 S1000\n"));
  EXPECT_THAT(klipper, HasSubstr("; two_cells, _, tier 1 of 2, from the bottom\n"));
  EXPECT_THAT(klipper, HasSubstr("One laboratory, one filament, one printer"));
  EXPECT_THAT(klipper, HasSubstr("M140 S55\n"));
  EXPECT_THAT(klipper, testing::Not(HasSubstr("{")));
}

TEST(WriteTier, PlainFilesNameNoStruts) {
  const std::string plain = writeTier(smallPlan(Flavour::marlin), 1, true).text;
  EXPECT_THAT(plain, testing::Not(HasSubstr("; strut")));
  EXPECT_THAT(plain, testing::Not(HasSubstr("; hub")));
  EXPECT_THAT(plain, HasSubstr(";TYPE:Perimeter\n"));
  EXPECT_LT(plain.size(), writeTier(smallPlan(Flavour::marlin), 1, false).text.size());
}

TEST(WriteTier, TheFirstPassIsSlow) {
  for (const GcodeMove& move :
       readGcode(writeTier(smallPlan(Flavour::marlin), 0, false).text).laid) {
    const bool isFirst = move.z < 0.081 || move.type == "Custom";
    EXPECT_NEAR(move.speed, isFirst ? 15 : move.name.rfind("strut", 0) == 0 ? 30 : 20, 1e-9);
  }
}

TEST(WriteTier, BesideTheBedIsRefused) {
  PrintPlan plan = smallPlan(Flavour::marlin);
  plan.positions.row(0).array() -= 200;
  try {
    writeTier(plan, 0, false);
    FAIL() << "what lies beside the bed is not refused";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "tier 1 would be laid beside the bed of 250 x 210 mm: a smaller scale would do");
  }
}

}  // namespace
}  // namespace morphgrid
