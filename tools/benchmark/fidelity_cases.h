#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "app/scene.h"

namespace morphgrid {

/// A target with its designs. Scenes are loaded when they are asked for.
struct FidelityCase {
  std::string name;
  bool random;  ///< A random patch, not a scene of the paper's.
  std::function<Scene()> papers;
  std::function<Scene()> springs;
  std::function<Scene()> ours;
};

/// The paper's five scenes with a surface and random patches of seeds from 1. scenes: the folder of
/// the scene files. Reads nothing yet.
std::vector<FidelityCase> listFidelityCases(const std::filesystem::path& scenes);

}  // namespace morphgrid
