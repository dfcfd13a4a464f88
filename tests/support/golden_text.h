#pragma once
#include <string>

namespace morphgrid {

/// What tests/golden/NAME holds; nothing where there is no such file.
std::string readGolden(const std::string& name);

/// Leaves a text where it can be looked at beside its golden file, and says where, and what to do.
std::string keepActual(const std::string& text, const std::string& name);

/// The same where the two differ; else nothing.
std::string differenceFromGolden(const std::string& text, const std::string& name);

}  // namespace morphgrid
