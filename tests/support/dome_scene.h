#pragma once

namespace morphgrid {

/// A scene that is solved at once.
inline constexpr const char* kDomeScene = R"(
title = "Dome"
[surface]
kind = "bend_angles"
theta_u = [0.2, 0.2]
theta_v = [0.2, 0.2]
spacing = 1.0
[grid]
layers = 3
layer_spacing = 0.2
nodes_u = 8
nodes_v = 8
max_shrinkage = 0.5
)";

}  // namespace morphgrid
