#pragma once
#include <optional>

#include "app/scene.h"
#include "core/toml_reader.h"

namespace morphgrid {

/// The sections of a scene file that stand alone. Problems go to the reader; a value in trouble
/// keeps its default.

Weights readWeights(TomlReader& reader);

struct SolverSettings {
  Method method = Method::multigrid;
  Scaling scaling = Scaling::normalised;
  SolveOptions options;
  bool smallestEigenvalue = false;
};
SolverSettings readSolverSettings(TomlReader& reader);

struct OutputChoices {
  PictureChoices pictures;
  FileChoices files;
};
OutputChoices readOutputChoices(TomlReader& reader);

/// Nothing when the file has no [paper].
std::optional<PublishedFigures> readPublishedFigures(TomlReader& reader);

}  // namespace morphgrid
