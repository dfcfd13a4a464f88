#pragma once
#include <string>

namespace morphgrid {

/// docs/scene_format.md with the tables of keys as sceneKeys() and meshConfigurationKeys() have
/// them, between the lines that mark them. Throws InputError where those are missing.
std::string withSceneKeys(std::string document);

}  // namespace morphgrid
