#pragma once
#include "core/error.h"

namespace morphgrid {

/// What was made cannot be written. For those that need not tell why, an InputError.
class OutputError : public InputError {
 public:
  using InputError::InputError;
};

}  // namespace morphgrid
