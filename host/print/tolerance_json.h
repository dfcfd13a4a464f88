#pragma once
#include <nlohmann/json.hpp>
#include <optional>

#include "print/print_tolerance.h"

namespace morphgrid {

/// The part of print.json; null where nothing was asked for.
nlohmann::ordered_json toleranceJson(const std::optional<PrintTolerance>& tolerance);

}  // namespace morphgrid
