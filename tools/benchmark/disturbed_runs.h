#pragma once
#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <vector>

namespace morphgrid {

/// The command `disturb`: runs of the program that are killed and resumed, that meet full disks and
/// that are interrupted, and how each one ended.
void addDisturbedRuns(CLI::App& app);

// What follows is its parts, a table each.

/// Where such runs take place.
struct DisturbedPlace {
  std::filesystem::path program;
  std::filesystem::path scenes;
  std::filesystem::path folder;  ///< Empty, for all that runs leave.

  std::string scene(const std::string& name) const { return scenes / (name + ".toml"); }
};

/// Markdown, with a sentence that counts. isWell: set to false where something went wrong.
std::string killAndResume(const DisturbedPlace& place, bool& isWell);
std::string fillDisks(const DisturbedPlace& place, bool& isWell);
std::string interruptPhases(const DisturbedPlace& place, bool& isWell);

/// Empty, or made so.
std::filesystem::path emptyFolder(const std::filesystem::path& folder);
/// Names of files in a folder that are not whole, as far as their formats tell.
std::vector<std::string> listHalfFiles(const std::filesystem::path& folder);
/// Files under construction, which begin with a dot.
int countTemporaries(const std::filesystem::path& folder);

}  // namespace morphgrid
