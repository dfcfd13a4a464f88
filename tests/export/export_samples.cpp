#include "tests/export/export_samples.h"

#include <fmt/format.h>
#include <stdlib.h>
#include <unistd.h>

#include <Eigen/Geometry>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <random>
#include <stdexcept>

#include "grid/bar_section.h"

namespace morphgrid {

OrdinaryUser::OrdinaryUser() : before_(geteuid()) {
  const uid_t nobody = 65534;
  if (before_ == 0 && seteuid(nobody) != 0) {
    throw std::runtime_error("root cannot become an ordinary user");
  }
}

OrdinaryUser::~OrdinaryUser() {
  if (before_ == 0 && seteuid(before_) != 0) {
    std::abort();  // The tests after this one would fail for no reason of theirs.
  }
}

FullDisk::FullDisk(rlim_t bytes) {
  handlerBefore_ = std::signal(SIGXFSZ, SIG_IGN);
  getrlimit(RLIMIT_FSIZE, &before_);
  const rlimit limit{bytes, before_.rlim_max};
  setrlimit(RLIMIT_FSIZE, &limit);
}

FullDisk::~FullDisk() {
  setrlimit(RLIMIT_FSIZE, &before_);
  std::signal(SIGXFSZ, handlerBefore_);
}

void writeFile(const std::filesystem::path& path, const std::string& content) {
  std::ofstream(path, std::ios::binary) << content;
}

ExportSample exportSample(const GridShape& shape) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> jitter(-0.2, 0.2);
  ExportSample sample{
      .grid = {.shape = shape, .spacing = 1, .rest = StrutValues(shape), .weights = {1}}};
  sample.positions.resize(3, shape.vertexCount());
  for (int vertex = 0; vertex < shape.vertexCount(); ++vertex) {
    const int onLayer = vertex % shape.layerVertexCount();
    sample.positions.col(vertex) << 1e3 + onLayer % shape.verticesU + jitter(random),
        1e-3 * (onLayer / shape.verticesU + jitter(random)),
        vertex / shape.layerVertexCount() + jitter(random);
  }
  sample.grid.positions = sample.positions;
  forEachStrut(shape, [&](const Strut& strut) {
    const double length =
        (sample.positions.col(strut.to) - sample.positions.col(strut.from)).norm();
    valueAt(sample.grid.rest, strut) = length * (1 + 1.5 * jitter(random));
  });
  sample.surface = tessellate(shape, middleLayer(shape, sample.positions), 2);
  return sample;
}

FrameSample frameSample(const GridShape& shape) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> jitter(-0.2, 0.2);
  const BarSection section = rectangularSection(
      {.width = kBarWidth, .height = kBarHeight, .poisson = 0.3, .joint = 0.02}, 5);
  FrameSample sample{exportSample(shape), JointRotations(4, shape.vertexCount())};
  forEachVertex(shape, [&](const GridPlace& place) {
    const int vertex = shape.index(place);
    const Eigen::Vector3d printed(place.i, place.j, place.layer);
    sample.grid.positions.col(vertex) = printed;
    sample.positions.col(vertex) =
        printed + Eigen::Vector3d(jitter(random), jitter(random), jitter(random));
    sample.rotations.col(vertex) =
        Eigen::Quaterniond(1, jitter(random), jitter(random), jitter(random)).normalized().coeffs();
  });
  forEachStrut(shape, [&](const Strut& strut) {
    valueAt(sample.grid.rest, strut) = 0.9 + 0.3 * jitter(random);
  });
  sample.grid.bars = Bars{section, section, sample.grid.positions};
  return sample;
}

std::string shapeName(const testing::TestParamInfo<GridShape>& test) {
  return fmt::format("{}x{}x{}", test.param.verticesU, test.param.verticesV, test.param.layers);
}

}  // namespace morphgrid
