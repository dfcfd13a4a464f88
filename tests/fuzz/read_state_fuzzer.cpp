#include <cstddef>
#include <cstdint>

#include "tests/fuzz/read_fuzzed_state.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  morphgrid::readFuzzedState({reinterpret_cast<const char*>(data), size});
  return 0;
}
