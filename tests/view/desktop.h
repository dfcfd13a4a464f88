#pragma once
#include <sys/types.h>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/support/temporary_folder.h"

namespace morphgrid {

/// A program that runs beside the test; killed at the end if it still does.
class BackgroundProgram {
 public:
  /// environment: more `NAME=value`s. stdout and stderr go to a file.
  BackgroundProgram(std::vector<std::string> command, const std::vector<std::string>& environment,
                    const std::filesystem::path& output);
  ~BackgroundProgram();
  BackgroundProgram(const BackgroundProgram&) = delete;
  BackgroundProgram& operator=(const BackgroundProgram&) = delete;

  /// Waits for its end; 128 + signal when one ended it.
  int exitCode();
  void signal(int number) const;
  /// What it has written so far.
  std::string output() const;

 private:
  pid_t child_;
  std::filesystem::path output_;
};

/// An X server without a screen, and what a user does there.
class Desktop {
 public:
  Desktop();

  std::string display() const { return display_; }
  const TemporaryFolder& folder() const { return folder_; }

  /// Waits for a window with such a title, an extended regular expression; returns its id. Empty
  /// when none comes within half a minute.
  std::string awaitWindow(const std::string& title) const;
  /// Keys as xdotool calls them, e.g. "ctrl+s".
  void press(const std::string& keys) const;
  void click(int x, int y) const;
  /// Runs a shell command on this display; returns what it wrote.
  std::string run(const std::string& command) const;
  /// Saves a picture of the whole screen; returns its file.
  std::filesystem::path screenshot(const std::string& name) const;

 private:
  TemporaryFolder folder_;
  std::string display_;
  BackgroundProgram server_;
};

}  // namespace morphgrid
