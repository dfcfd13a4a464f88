#pragma once
#include <filesystem>
#include <string>

#include "gpu/device.h"

namespace morphgrid {

// Markdown tables of docs/validation.md, each computed anew. references: the folder
// tests/solve/frames. They throw InputError where a file there cannot be read, DeviceError when the
// device fails.

/// A chain of bars that an end moment rolls up to a full circle.
std::string circleTable();

/// Ladders beside their closed form.
std::string ladderTable(const Device& device);

/// Grids beside an independent solver in double precision.
std::string oracleTable(const Device& device, const std::filesystem::path& references);

/// Ladders' angles, and all joints' places, beside solids that grow.
std::string solidLadderTable(const Device& device, const std::filesystem::path& references);
std::string solidTable(const Device& device, const std::filesystem::path& references);

/// One element a bar beside two.
std::string subdivisionTable(const std::filesystem::path& references);

/// A grid that is turned, moved, measured in another unit, mirrored.
std::string invarianceTable(const Device& device, const std::filesystem::path& references);

}  // namespace morphgrid
