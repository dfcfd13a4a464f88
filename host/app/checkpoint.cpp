#include "app/checkpoint.h"

#include <fmt/format.h>
#include <zlib.h>

#include <cstring>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <span>

#include "app/design_scene.h"
#include "core/atomic_file.h"
#include "core/error.h"
#include "core/read_file.h"

namespace morphgrid {
namespace {

using nlohmann::ordered_json;

// The file: this line with the version, a line of JSON, doubles, and the CRC-32 of all that.
constexpr std::string_view kMagic = "morphgrid checkpoint ";
constexpr int kVersion = 1;
constexpr std::size_t kSampleDoubles = 5;

[[noreturn]] void refuse(const std::filesystem::path& file, std::string_view why) {
  throw InputError(fmt::format("{}: {}", file.string(), why));
}

std::uint32_t checksum(std::string_view bytes) {
  return static_cast<std::uint32_t>(
      crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

std::string digest(const std::vector<double>& a, const std::vector<double>& b) {
  const auto bytes = [](const std::vector<double>& values) {
    return std::string_view(reinterpret_cast<const char*>(values.data()),
                            values.size() * sizeof(double));
  };
  return fmt::format("{:08x}{:08x}", checksum(bytes(a)), checksum(bytes(b)));
}

void append(std::string& bytes, std::span<const double> values) {
  bytes.append(reinterpret_cast<const char*>(values.data()), values.size_bytes());
}

void append(std::string& bytes, const Eigen::Matrix3Xd& positions,
            const std::vector<ConvergenceSample>& history) {
  append(bytes, {positions.data(), static_cast<std::size_t>(positions.size())});
  for (const ConvergenceSample& s : history) {
    const double values[kSampleDoubles] = {static_cast<double>(s.iteration), s.energy, s.residual,
                                           s.seconds, s.gridShare};
    append(bytes, values);
  }
}

ordered_json headerOf(const Checkpoint& checkpoint) {
  const SolveCheckpoint& solve = checkpoint.solve;
  ordered_json header{{"settings", checkpoint.settings},
                      {"solve",
                       {{"phase", solve.phase},
                        {"iterations", solve.iterations},
                        {"seconds", solve.seconds},
                        {"positions", solve.positions.cols()},
                        {"samples", solve.history.size()}}}};
  if (checkpoint.inPlane) {
    const Equilibrium& inPlane = *checkpoint.inPlane;
    header["in_plane"] = {{"iterations", inPlane.iterations},
                          {"converged", inPlane.converged},
                          {"reason", static_cast<int>(inPlane.reason)},
                          {"residual", inPlane.residual},
                          {"energy", inPlane.energy},
                          {"seconds", inPlane.seconds},
                          {"positions", inPlane.positions.cols()},
                          {"samples", inPlane.history.size()}};
  }
  return header;
}

/// Takes doubles off the front of what is left of a file.
class DoubleReader {
 public:
  explicit DoubleReader(std::string_view bytes) : bytes_(bytes) {}

  /// Throws std::length_error when fewer than `count` are left.
  void take(std::size_t count, double* values) {
    if (count > bytes_.size() / sizeof(double)) {
      throw std::length_error("fewer numbers than announced");
    }
    std::memcpy(values, bytes_.data(), count * sizeof(double));
    bytes_.remove_prefix(count * sizeof(double));
  }
  bool atEnd() const { return bytes_.empty(); }
  std::size_t left() const { return bytes_.size() / sizeof(double); }

 private:
  std::string_view bytes_;
};

/// The positions and samples that `announced` counts.
void take(DoubleReader& reader, const ordered_json& announced, Eigen::Matrix3Xd& positions,
          std::vector<ConvergenceSample>& history) {
  const auto columns = announced.at("positions").get<std::size_t>();
  const auto samples = announced.at("samples").get<std::size_t>();
  if (columns > reader.left() || samples > reader.left()) {
    throw std::length_error("fewer numbers than announced");
  }
  positions.resize(3, static_cast<Eigen::Index>(columns));
  reader.take(3 * columns, positions.data());
  for (std::size_t n = 0; n < samples; ++n) {
    double values[kSampleDoubles];
    reader.take(kSampleDoubles, values);
    history.push_back({static_cast<long>(values[0]), values[1], values[2], values[3], values[4]});
  }
}

Equilibrium takeInPlane(DoubleReader& reader, const ordered_json& announced) {
  Equilibrium inPlane;
  inPlane.iterations = announced.at("iterations").get<long>();
  inPlane.converged = announced.at("converged").get<bool>();
  inPlane.reason = static_cast<StopReason>(announced.at("reason").get<int>());
  inPlane.residual = announced.at("residual").get<double>();
  inPlane.energy = announced.at("energy").get<double>();
  inPlane.seconds = announced.at("seconds").get<double>();
  take(reader, announced, inPlane.positions, inPlane.history);
  return inPlane;
}

/// What lies between the magic line and the checksum. Throws when it contradicts itself.
Checkpoint parse(std::string_view content) {
  const auto end = content.find('\n');
  const auto header = ordered_json::parse(content.substr(0, end));
  DoubleReader reader(content.substr(end + 1));
  Checkpoint checkpoint;
  checkpoint.settings = header.at("settings").get<std::map<std::string, std::string>>();
  if (header.contains("in_plane")) {
    checkpoint.inPlane = takeInPlane(reader, header.at("in_plane"));
  }
  const ordered_json& solve = header.at("solve");
  checkpoint.solve.phase = solve.at("phase").get<int>();
  checkpoint.solve.iterations = solve.at("iterations").get<double>();
  checkpoint.solve.seconds = solve.at("seconds").get<double>();
  take(reader, solve, checkpoint.solve.positions, checkpoint.solve.history);
  if (!reader.atEnd()) {
    throw std::length_error("more numbers than announced");
  }
  return checkpoint;
}

bool isCheckpoint(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string start(kMagic.size(), '\0');
  stream.read(start.data(), static_cast<std::streamsize>(start.size()));
  return stream && start == kMagic;
}

}  // namespace

std::map<std::string, std::string> checkpointSettings(const Scene& scene,
                                                      const GridDesign& design) {
  return {
      {"nodes", fmt::format("{} x {}", design.nodesU, design.nodesV)},
      {"layers", fmt::format("{}", design.layers)},
      {"layer spacing", fmt::format("{}", design.layerSpacing)},
      {"spacing", fmt::format("{}", design.spacing)},
      {"lengths (digest)", digest(design.lengths.allU(), design.lengths.allV())},
      {"bend angles (digest)", digest(design.bendAngles.allU(), design.bendAngles.allV())},
      {"weights", fmt::format("lateral {}, vertical {}, angle {}", scene.weights.lateral,
                              scene.weights.vertical, scene.weights.angle)},
      {"scaling", nameOf(scene.scaling)},
      {"method", nameOf(scene.method)},
  };
}

void writeCheckpoint(const std::filesystem::path& file, const Checkpoint& checkpoint) {
  std::string bytes = fmt::format("{}{}\n{}\n", kMagic, kVersion, headerOf(checkpoint).dump());
  if (checkpoint.inPlane) {
    append(bytes, checkpoint.inPlane->positions, checkpoint.inPlane->history);
  }
  append(bytes, checkpoint.solve.positions, checkpoint.solve.history);
  const std::uint32_t sum = checksum(bytes);
  bytes.append(reinterpret_cast<const char*>(&sum), sizeof(sum));
  writeFileAtomically(file, bytes);
}

Checkpoint readCheckpoint(const std::filesystem::path& file) {
  const std::string bytes = readFile(file);
  if (!bytes.starts_with(kMagic)) {
    refuse(file, "is no checkpoint of morphgrid; --resume takes what --checkpoint wrote");
  }
  constexpr const char* kDamaged =
      "the checkpoint is damaged or cut short; resume from another one or start anew";
  const auto end = bytes.find('\n');
  if (end == std::string::npos) {
    refuse(file, kDamaged);
  }
  const std::string version = bytes.substr(kMagic.size(), end - kMagic.size());
  if (version != std::to_string(kVersion)) {
    refuse(file, fmt::format("the checkpoint has format {}, this morphgrid reads format {}; resume "
                             "with the version that wrote it or start anew",
                             version, kVersion));
  }
  std::uint32_t sum = 0;
  const auto content = std::string_view(bytes).substr(0, bytes.size() - sizeof(sum));
  std::memcpy(&sum, bytes.data() + content.size(), sizeof(sum));
  if (checksum(content) != sum) {
    refuse(file, kDamaged);
  }
  try {
    return parse(content.substr(end + 1));
  } catch (const std::exception&) {
    refuse(file, kDamaged);
  }
}

void requireSameSettings(const std::filesystem::path& file, const Checkpoint& checkpoint,
                         const std::map<std::string, std::string>& settings) {
  std::string differences;
  for (const auto& [name, wanted] : settings) {
    const auto found = checkpoint.settings.find(name);
    const std::string had = found == checkpoint.settings.end() ? "unknown" : found->second;
    if (had != wanted) {
      differences +=
          fmt::format("\n  {}: {} in the checkpoint, {} in the scene", name, had, wanted);
    }
  }
  if (!differences.empty()) {
    refuse(file, fmt::format("the checkpoint is of another scene or of other settings; give those "
                             "that it was written with, or start anew{}",
                             differences));
  }
}

void requireWritableCheckpoint(const std::filesystem::path& file) {
  std::error_code ignored;  // What cannot be looked at cannot be written either.
  if (std::filesystem::exists(file, ignored) && !isCheckpoint(file)) {
    refuse(file,
           "is there and no checkpoint; --checkpoint does not overwrite it: give another name");
  }
  const PendingFile probe(file);
  if (!std::ofstream(probe.path())) {
    refuse(file, "no checkpoint can be written there: is the folder there and writable?");
  }
}

}  // namespace morphgrid
