#include "app/checkpoint.h"

#include <fmt/format.h>

#include <fstream>
#include <utility>

#include "core/atomic_file.h"
#include "core/error.h"
#include "core/named_arrays.h"
#include "state/history_array.h"

namespace morphgrid {
namespace {

constexpr ArrayFormat kCheckpointFormat{
    "morphgrid checkpoint", 5, "checkpoint",
    "resume from another one that --checkpoint wrote, or start anew"};

// Settings are texts whose names begin like this.
constexpr std::string_view kSetting = "setting ";
constexpr std::size_t kStepNumbers = 10;
constexpr int kLargestPhase = 1 << 20;
constexpr int kLargestCount = 1 << 30;

void addVector(ArrayList& arrays, const std::string& name, const Eigen::VectorXd& values) {
  arrays.add(name, {static_cast<std::size_t>(values.size())}, values);
}

Eigen::VectorXd readVector(const ArrayReader& reader, const std::string& name) {
  const ArrayShape& shape = reader.file().shapeOf(name);
  reader.require(shape.size() == 1);
  const std::vector<double> values = reader.numbers(name, shape);
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(shape[0]));
}

void addPositions(ArrayList& arrays, const std::string& name, const Eigen::Matrix3Xd& positions) {
  arrays.add(name, {static_cast<std::size_t>(positions.cols()), 3}, positions);
}

Eigen::Matrix3Xd readPositions(const ArrayReader& reader, const std::string& name) {
  return reader.points(name, {reader.rowCount(name, 3), 3});
}

/// None where joints do not turn.
void addRotations(ArrayList& arrays, const std::string& name, const JointRotations& rotations) {
  if (rotations.cols() > 0) {
    arrays.add(name, {static_cast<std::size_t>(rotations.cols()), 4}, rotations);
  }
}

JointRotations readRotations(const ArrayReader& reader, const std::string& name) {
  if (!reader.has(name)) {
    return JointRotations(4, 0);
  }
  const std::size_t count = reader.rowCount(name, 4);
  const std::vector<double> values = reader.numbers(name, {count, 4});
  return Eigen::Map<const JointRotations>(values.data(), 4, static_cast<Eigen::Index>(count));
}

void add(ArrayList& arrays, const std::string& name, const Equilibrium& equilibrium) {
  addPositions(arrays, name + "_positions", equilibrium.positions);
  addRotations(arrays, name + "_rotations", equilibrium.rotations);
  arrays.addMade(name + "_summary", {6},
                 {static_cast<double>(equilibrium.iterations), equilibrium.converged ? 1.0 : 0.0,
                  static_cast<double>(equilibrium.reason), equilibrium.residual, equilibrium.energy,
                  equilibrium.seconds});
  addHistory(arrays, name + "_history", equilibrium.history);
}

Equilibrium readEquilibrium(const ArrayReader& reader, const std::string& name) {
  const std::vector<double> summary = reader.bare(name + "_summary", {6});
  Equilibrium equilibrium;
  equilibrium.positions = readPositions(reader, name + "_positions");
  equilibrium.rotations = readRotations(reader, name + "_rotations");
  equilibrium.iterations = reader.integer(summary[0], 0, kLargestExactInteger);
  equilibrium.converged = reader.integer(summary[1], 0, 1) == 1;
  equilibrium.reason = static_cast<StopReason>(
      reader.integer(summary[2], 0, static_cast<double>(StopReason::laidOut)));
  equilibrium.residual = summary[3];
  equilibrium.energy = summary[4];
  equilibrium.seconds = summary[5];
  equilibrium.history = readHistory(reader, name + "_history");
  return equilibrium;
}

void add(ArrayList& arrays, const SolveCheckpoint& solve) {
  addPositions(arrays, "solve_positions", solve.positions);
  addRotations(arrays, "solve_rotations", solve.rotations);
  arrays.addMade("solve_summary", {3},
                 {static_cast<double>(solve.phase), solve.iterations, solve.seconds});
  addHistory(arrays, "solve_history", solve.history);
}

SolveCheckpoint readSolve(const ArrayReader& reader) {
  const std::vector<double> summary = reader.numbers("solve_summary", {3});
  return {static_cast<int>(reader.integer(summary[0], 0, kLargestPhase)),
          readPositions(reader, "solve_positions"),
          readRotations(reader, "solve_rotations"),
          summary[1],
          summary[2],
          readHistory(reader, "solve_history")};
}

void addSteps(ArrayList& arrays, const std::vector<InverseStep>& steps) {
  std::vector<double> values;
  for (const InverseStep& step : steps) {
    values.insert(values.end(), {static_cast<double>(step.kind), static_cast<double>(step.number),
                                 step.rmsPercent, step.maxPercent, step.largestShrinkPercent,
                                 step.largestStrainPercent, static_cast<double>(step.strutsAtBound),
                                 static_cast<double>(step.cycles),
                                 static_cast<double>(step.adjointProducts), step.seconds});
  }
  arrays.addMade("inverse_steps", {steps.size(), kStepNumbers}, std::move(values));
}

std::vector<InverseStep> readSteps(const ArrayReader& reader) {
  const std::size_t count = reader.rowCount("inverse_steps", kStepNumbers);
  const std::vector<double> values = reader.bare("inverse_steps", {count, kStepNumbers});
  std::vector<InverseStep> steps;
  for (auto at = values.begin(); at != values.end(); at += kStepNumbers) {
    const auto kind = static_cast<InverseStep::Kind>(
        reader.integer(at[0], 0, static_cast<double>(InverseStep::Kind::optimise)));
    const auto countAt = [&](int n) { return reader.integer(at[n], 0, kLargestCount); };
    steps.push_back({kind, static_cast<int>(countAt(1)), at[2], at[3], at[4], at[5], countAt(6),
                     countAt(7), static_cast<int>(countAt(8)), at[9]});
  }
  return steps;
}

std::string pairName(std::size_t n) { return fmt::format("inverse_pair_{}", n); }

void add(ArrayList& arrays, const InverseCheckpoint& inverse) {
  arrays.addMade("inverse_summary", {3},
                 {inverse.compensated ? 1.0 : 0.0, static_cast<double>(inverse.keptSteps),
                  static_cast<double>(inverse.returns)});
  addVector(arrays, "present_rest", inverse.present.rest);
  add(arrays, "present", inverse.present.equilibrium);
  addVector(arrays, "kept_rest", inverse.kept.rest);
  add(arrays, "kept", inverse.kept.equilibrium);
  if (inverse.aim.cols() > 0) addPositions(arrays, "inverse_aim", inverse.aim);
  addSteps(arrays, inverse.steps);
  arrays.add("inverse_objectives", {inverse.objectives.size()},
             std::span<const double>(inverse.objectives));
  for (std::size_t n = 0; n < inverse.pairs.size(); ++n) {
    addVector(arrays, pairName(n) + "_step", inverse.pairs[n].step);
    addVector(arrays, pairName(n) + "_change", inverse.pairs[n].change);
  }
}

InverseCheckpoint readInverse(const ArrayReader& reader) {
  const std::vector<double> summary = reader.bare("inverse_summary", {3});
  const Eigen::VectorXd objectives = readVector(reader, "inverse_objectives");
  InverseCheckpoint inverse{
      reader.integer(summary[0], 0, 1) == 1,
      {readVector(reader, "present_rest"), readEquilibrium(reader, "present")},
      {readVector(reader, "kept_rest"), readEquilibrium(reader, "kept")},
      static_cast<std::size_t>(reader.integer(summary[1], 0, kLargestCount)),
      static_cast<int>(reader.integer(summary[2], 0, kLargestCount)),
      readSteps(reader),
      {objectives.begin(), objectives.end()},
      {}};
  for (std::size_t n = 0; reader.has(pairName(n) + "_step"); ++n) {
    inverse.pairs.push_back(
        {readVector(reader, pairName(n) + "_step"), readVector(reader, pairName(n) + "_change")});
  }
  if (reader.has("inverse_aim")) inverse.aim = readPositions(reader, "inverse_aim");
  return inverse;
}

std::vector<NamedText> textsOf(const ProblemIdentity& problem) {
  std::vector<NamedText> texts{{"digest", problem.digest}};
  for (const auto& [name, value] : problem.settings) {
    texts.push_back({std::string(kSetting) + name, value});
  }
  return texts;
}

ProblemIdentity readProblem(const ArrayFile& file) {
  ProblemIdentity problem{file.text("digest"), {}};
  for (const auto& [name, value] : file.texts()) {
    if (name.starts_with(kSetting)) {
      problem.settings.emplace(name.substr(kSetting.size()), value);
    }
  }
  return problem;
}

}  // namespace

void writeCheckpoint(const std::filesystem::path& file, const Checkpoint& checkpoint) {
  ArrayList arrays;
  if (checkpoint.inPlane) add(arrays, "in_plane", *checkpoint.inPlane);
  if (checkpoint.full) add(arrays, "full", *checkpoint.full);
  if (checkpoint.solve) add(arrays, *checkpoint.solve);
  if (checkpoint.inverse) add(arrays, *checkpoint.inverse);
  writeArrayFile(file, kCheckpointFormat, textsOf(checkpoint.problem), arrays.all());
}

Checkpoint readCheckpoint(const std::filesystem::path& path) {
  const ArrayFile file(path, kCheckpointFormat);
  const ArrayReader reader(file);
  Checkpoint checkpoint{readProblem(file), {}, {}, {}, {}};
  if (reader.has("in_plane_summary")) checkpoint.inPlane = readEquilibrium(reader, "in_plane");
  if (reader.has("full_summary")) checkpoint.full = readEquilibrium(reader, "full");
  if (reader.has("solve_summary")) checkpoint.solve = readSolve(reader);
  if (reader.has("inverse_summary")) checkpoint.inverse = readInverse(reader);
  return checkpoint;
}

void requireSameProblem(const std::filesystem::path& file, const Checkpoint& checkpoint,
                        const ProblemIdentity& problem) {
  if (checkpoint.problem.digest != problem.digest) {
    throw InputError(
        fmt::format("{}: the checkpoint is of another scene or of other settings; "
                    "give those that it was written with, or start anew; what "
                    "differs:{}",
                    file.string(), describeDifferences(checkpoint.problem, problem)));
  }
}

void requireWritableCheckpoint(const std::filesystem::path& file) {
  std::error_code ignored;  // What cannot be looked at cannot be written either.
  if (std::filesystem::exists(file, ignored) && !looksLike(kCheckpointFormat, file)) {
    throw InputError(
        fmt::format("{}: is there and no checkpoint; --checkpoint does not overwrite "
                    "it: give another name",
                    file.string()));
  }
  const PendingFile probe(file);
  if (!std::ofstream(probe.path())) {
    throw InputError(
        fmt::format("{}: no checkpoint can be written there: is the folder there and "
                    "writable?",
                    file.string()));
  }
}

}  // namespace morphgrid
