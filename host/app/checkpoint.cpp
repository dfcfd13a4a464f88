#include "app/checkpoint.h"

#include <fmt/format.h>

#include <fstream>
#include <utility>

#include "core/atomic_file.h"
#include "core/binary_file.h"
#include "core/error.h"

namespace morphgrid {
namespace {

constexpr BinaryFormat kCheckpointFormat{
    "checkpoint", 2, "resume from another one that --checkpoint wrote, or start anew"};

constexpr std::size_t kSampleBytes = 5 * sizeof(double);
constexpr std::size_t kStepBytes = 9 * sizeof(double);

void addHistory(BinaryWriter& writer, const std::vector<ConvergenceSample>& history) {
  writer.integer(static_cast<std::int64_t>(history.size()));
  for (const ConvergenceSample& s : history) {
    writer.integer(s.iteration).number(s.energy).number(s.residual);
    writer.number(s.seconds).number(s.gridShare);
  }
}

std::vector<ConvergenceSample> takeHistory(BinaryReader& reader) {
  std::vector<ConvergenceSample> history(reader.count(kSampleBytes));
  for (ConvergenceSample& s : history) {
    s.iteration = reader.integer();
    s.energy = reader.number();
    s.residual = reader.number();
    s.seconds = reader.number();
    s.gridShare = reader.number();
  }
  return history;
}

void add(BinaryWriter& writer, const Equilibrium& equilibrium) {
  writer.points(equilibrium.positions).integer(equilibrium.iterations);
  writer.integer(equilibrium.converged ? 1 : 0).integer(static_cast<int>(equilibrium.reason));
  writer.number(equilibrium.residual).number(equilibrium.energy).number(equilibrium.seconds);
  addHistory(writer, equilibrium.history);
}

Equilibrium takeEquilibrium(BinaryReader& reader) {
  Equilibrium equilibrium;
  equilibrium.positions = reader.points();
  equilibrium.iterations = reader.integer();
  equilibrium.converged = reader.integer(0, 1) == 1;
  equilibrium.reason = static_cast<StopReason>(
      reader.integer(0, static_cast<std::int64_t>(StopReason::deviceFailure)));
  equilibrium.residual = reader.number();
  equilibrium.energy = reader.number();
  equilibrium.seconds = reader.number();
  equilibrium.history = takeHistory(reader);
  return equilibrium;
}

void add(BinaryWriter& writer, const SolveCheckpoint& solve) {
  writer.integer(solve.phase).points(solve.positions);
  writer.number(solve.iterations).number(solve.seconds);
  addHistory(writer, solve.history);
}

SolveCheckpoint takeSolve(BinaryReader& reader) {
  SolveCheckpoint solve;
  solve.phase = static_cast<int>(reader.integer(0, 1 << 20));
  solve.positions = reader.points();
  solve.iterations = reader.number();
  solve.seconds = reader.number();
  solve.history = takeHistory(reader);
  return solve;
}

void add(BinaryWriter& writer, const InverseStep& step) {
  writer.integer(static_cast<int>(step.kind)).integer(step.number);
  writer.number(step.rmsPercent).number(step.maxPercent).number(step.largestShrinkPercent);
  writer.integer(step.strutsAtBound).integer(step.cycles).integer(step.adjointProducts);
  writer.number(step.seconds);
}

InverseStep takeStep(BinaryReader& reader) {
  InverseStep step{};
  step.kind = static_cast<InverseStep::Kind>(
      reader.integer(0, static_cast<std::int64_t>(InverseStep::Kind::optimise)));
  step.number = static_cast<int>(reader.integer(0, std::int64_t{1} << 30));
  step.rmsPercent = reader.number();
  step.maxPercent = reader.number();
  step.largestShrinkPercent = reader.number();
  step.strutsAtBound = reader.integer();
  step.cycles = reader.integer();
  step.adjointProducts = static_cast<int>(reader.integer(0, std::int64_t{1} << 30));
  step.seconds = reader.number();
  return step;
}

void add(BinaryWriter& writer, const InverseCheckpoint& inverse) {
  writer.integer(inverse.compensated ? 1 : 0);
  for (const InverseCheckpoint::Design* design : {&inverse.present, &inverse.kept}) {
    writer.numbers(design->rest);
    add(writer, design->equilibrium);
  }
  writer.integer(static_cast<std::int64_t>(inverse.keptSteps));
  writer.integer(static_cast<std::int64_t>(inverse.steps.size()));
  for (const InverseStep& step : inverse.steps) {
    add(writer, step);
  }
  writer.numbers(inverse.objectives);
  writer.integer(static_cast<std::int64_t>(inverse.pairs.size()));
  for (const BoundedLbfgs::Pair& pair : inverse.pairs) {
    writer.numbers(pair.step).numbers(pair.change);
  }
}

InverseCheckpoint takeInverse(BinaryReader& reader) {
  InverseCheckpoint inverse;
  inverse.compensated = reader.integer(0, 1) == 1;
  for (InverseCheckpoint::Design* design : {&inverse.present, &inverse.kept}) {
    design->rest = reader.vector();
    design->equilibrium = takeEquilibrium(reader);
  }
  inverse.keptSteps = static_cast<std::size_t>(reader.integer(0, std::int64_t{1} << 30));
  for (std::size_t left = reader.count(kStepBytes); left > 0; --left) {
    inverse.steps.push_back(takeStep(reader));
  }
  inverse.objectives = reader.numbers();
  for (std::size_t left = reader.count(2 * sizeof(std::int64_t)); left > 0; --left) {
    BoundedLbfgs::Pair pair;
    pair.step = reader.vector();
    pair.change = reader.vector();
    inverse.pairs.push_back(std::move(pair));
  }
  return inverse;
}

void add(BinaryWriter& writer, const ProblemIdentity& problem) {
  writer.text(problem.digest).integer(static_cast<std::int64_t>(problem.settings.size()));
  for (const auto& [name, value] : problem.settings) {
    writer.text(name).text(value);
  }
}

ProblemIdentity takeProblem(BinaryReader& reader) {
  ProblemIdentity problem{reader.text(), {}};
  for (std::size_t left = reader.count(2 * sizeof(std::int64_t)); left > 0; --left) {
    std::string name = reader.text();
    problem.settings.emplace(std::move(name), reader.text());
  }
  return problem;
}

template <typename T>
void addOptional(BinaryWriter& writer, const std::optional<T>& value) {
  writer.integer(value ? 1 : 0);
  if (value) {
    add(writer, *value);
  }
}

template <typename Take>
auto takeOptional(BinaryReader& reader, const Take& take) {
  return reader.integer(0, 1) == 1 ? std::optional(take(reader)) : std::nullopt;
}

}  // namespace

void writeCheckpoint(const std::filesystem::path& file, const Checkpoint& checkpoint) {
  BinaryWriter writer;
  add(writer, checkpoint.problem);
  addOptional(writer, checkpoint.inPlane);
  addOptional(writer, checkpoint.full);
  addOptional(writer, checkpoint.solve);
  addOptional(writer, checkpoint.inverse);
  writeBinaryFile(file, kCheckpointFormat, writer);
}

Checkpoint readCheckpoint(const std::filesystem::path& file) {
  return readBinaryFile(file, kCheckpointFormat, [](BinaryReader& reader) {
    Checkpoint checkpoint;
    checkpoint.problem = takeProblem(reader);
    checkpoint.inPlane = takeOptional(reader, takeEquilibrium);
    checkpoint.full = takeOptional(reader, takeEquilibrium);
    checkpoint.solve = takeOptional(reader, takeSolve);
    checkpoint.inverse = takeOptional(reader, takeInverse);
    return checkpoint;
  });
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
  if (std::filesystem::exists(file, ignored) && !isBinaryFile(file, kCheckpointFormat)) {
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
