#pragma once
#include <limits>

#include "app/scene.h"
#include "core/document_toml_key.h"
#include "core/toml_key.h"

namespace morphgrid {

using SceneKey = TomlKey<Scene>;
using SceneKeySection = TomlKeySection<Scene>;

/// The range of counts of things of which there must be one.
inline constexpr IntegerRange kCounts{1, std::numeric_limits<int>::max()};

/// What `true_shape` means where a scene does not say otherwise.
struct TrueShape {
  Model model = Model::frame;
  double leastShrinkage = 0.02;
  int compensateRounds = 10;
  int optimiseSteps = 20;
  bool enforceShrinkage = true;
};
inline constexpr TrueShape kTrueShape;

/// All keys of scene files, section by section: readers, knobs and docs/scene_format.md come from
/// here. Kinds are those of surfaces, as SurfaceRequest has them.
const std::vector<SceneKeySection>& sceneKeys();

/// The kinds of surfaces, and what a scene of each begins with.
const RecordKinds<Scene>& sceneKinds();

/// What a request of this kind begins with.
SurfaceRequest emptyRequest(std::size_t kind);

/// From a fifth of a quantity > 0 to five times as much.
KnobOffer aroundItsValue(std::string label);

/// visit(section, key, const FileKey<Scene>&) of each key that names a file; the names as in
/// sceneKeys().
template <typename Visit>
void forEachFileKey(Visit visit) {
  for (const SceneKeySection& section : sceneKeys()) {
    for (const SceneKey& key : section.keys) {
      if (const auto* file = std::get_if<FileKey<Scene>>(&key.value)) {
        visit(section.name, key.name, *file);
      }
    }
  }
}

// Parts of sceneKeys(), each in a file of its own.
SceneKeySection surfaceKeys();
SceneKeySection gridKeys();
SceneKeySection designKeys();
SceneKeySection materialKeys();
SceneKeySection printKeys();

}  // namespace morphgrid
