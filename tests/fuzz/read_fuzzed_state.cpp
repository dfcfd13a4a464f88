#include "tests/fuzz/read_fuzzed_state.h"

#include <zlib.h>

#include <algorithm>
#include <stdexcept>

#include "core/error.h"
#include "state/run_state.h"
#include "tests/support/temporary_folder.h"

namespace morphgrid {
namespace {

void expect(bool holds, const char* what) {
  if (!holds) throw std::logic_error(what);
}

std::string littleEndian(std::uint64_t value, int bytes) {
  std::string text;
  for (int n = 0; n < bytes; ++n) {
    text += static_cast<char>(value >> (8 * n) & 0xff);
  }
  return text;
}

void expectSound(const RunState& state) {
  const GridShape& shape = state.grid.shape;
  const Eigen::Index layer = shape.layerVertexCount();
  validate(state.grid);
  expect(state.design.nodesU + 1 == shape.verticesU && state.design.nodesV + 1 == shape.verticesV,
         "another design");
  expect(state.design.rest.size() == static_cast<std::size_t>(shape.layers), "layers missing");
  expect(state.record.inPlane && state.record.inPlane->positions.cols() == layer, "no layer");
  expect(state.equilibrium().positions.cols() == shape.vertexCount(), "no result");
  expect(state.equilibrium().positions.allFinite(), "a result that is no number");
  expect(!state.targets || state.targets->cols() == layer, "another target");
  if (state.sampling) {
    const auto& [mesh, hits] = *state.sampling;
    expect(mesh.triangles.minCoeff() >= 0 && mesh.triangles.maxCoeff() < mesh.vertices.cols(),
           "index beyond the last vertex");
    expect(hits.points.cols() == Eigen::Index{hits.countU} * hits.countV, "rays missing");
  }
}

}  // namespace

std::string framedState(std::string_view input) {
  const std::string_view header = input.substr(0, input.find('\n'));
  std::string bytes = littleEndian(header.size(), 8) + std::string(header);
  bytes += input.substr(std::min(header.size() + 1, input.size()));
  const auto sum = crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
  return bytes + littleEndian(sum, 4);
}

void readFuzzedState(std::string_view input) {
  static const TemporaryFolder folder;
  const std::filesystem::path file = folder.write("fuzzed.safetensors", framedState(input));
  try {
    expectSound(readState(file));
  } catch (const InputError& error) {
    const std::string message = folder.withoutPath(error.what());
    expect(message.starts_with("fuzzed.safetensors: "), "error without the file's name");
    expect(message.size() < 400 && std::ranges::count(message, '\n') == 0, "error too long");
  }
}

}  // namespace morphgrid
