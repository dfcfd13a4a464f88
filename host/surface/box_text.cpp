#include "surface/box_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/decimals.h"

namespace morphgrid {
namespace {

// Rounding moves an edge by less than half of this share of the box.
constexpr double kShare = 1e-3;

int decimalsOf(const SamplingBox& box) {
  return decimalsFor(kShare * std::min(box.uLength, box.vLength));
}

}  // namespace

SamplingBox roundedBox(const SamplingBox& box) {
  const int decimals = decimalsOf(box);
  return {roundedTo(box.uStart, decimals), roundedTo(box.vStart, decimals),
          roundedTo(box.uLength, decimals), roundedTo(box.vLength, decimals)};
}

std::string boxAsToml(const SamplingBox& box) {
  const int decimals = decimalsOf(box);
  const auto text = [&](double value) { return inDecimals(value, decimals); };
  return fmt::format("u_start = {}\nv_start = {}\nu_length = {}\nv_length = {}", text(box.uStart),
                     text(box.vStart), text(box.uLength), text(box.vLength));
}

}  // namespace morphgrid
