#include <cstddef>
#include <cstdint>

#include "tests/fuzz/read_fuzzed_mesh.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  morphgrid::readFuzzedMesh({reinterpret_cast<const char*>(data), size});
  return 0;
}
