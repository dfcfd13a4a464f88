#pragma once
#include <cstdint>
#include <span>

namespace morphgrid {

/// A shader as the build embeds it: static data.
struct ShaderCode {
  const char* name;  ///< The name of its file, "sweep.comp".
  std::span<const std::uint32_t> words;
};

}  // namespace morphgrid
