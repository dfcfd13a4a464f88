#pragma once
#include <vector>

#include "app/scene.h"
#include "view/session.h"

namespace morphgrid {

/// The settings of a scene that a viewer offers to turn.
std::vector<Knob> knobsOf(const Scene& scene);

/// As they were with the values that were set since; knobs keep their range where it holds the
/// value.
std::vector<Knob> keepRanges(std::vector<Knob> knobs, const std::vector<Knob>& before);

/// The knob with this text, as it goes into a scene file, for its value; unchanged where the text
/// says nothing.
Knob turned(Knob knob, const std::string& text);

}  // namespace morphgrid
