#include "tests/view/desktop.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace morphgrid {
namespace {

constexpr int kTries = 600;
constexpr std::chrono::milliseconds kPause(50);

[[noreturn]] void becomeProgram(std::vector<std::string>& command,
                                const std::vector<std::string>& environment,
                                const std::filesystem::path& output) {
  const int file = open(output.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  dup2(file, STDOUT_FILENO);
  dup2(file, STDERR_FILENO);
  for (const std::string& variable : environment) {
    const auto equals = variable.find('=');
    setenv(variable.substr(0, equals).c_str(), variable.substr(equals + 1).c_str(), 1);
  }
  std::vector<char*> pointers;
  for (std::string& argument : command) {
    pointers.push_back(argument.data());
  }
  pointers.push_back(nullptr);
  execvp(pointers[0], pointers.data());
  _exit(127);
}

std::string contentOf(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

/// The server chooses a free display and writes its number, alone on a line; complaints about those
/// that are taken come before.
std::string awaitDisplay(const BackgroundProgram& server) {
  for (int n = 0; n < kTries; ++n) {
    std::istringstream lines(server.output());
    for (std::string line; std::getline(lines, line) && !lines.eof();) {
      if (!line.empty() && line.find_first_not_of("0123456789") == std::string::npos) {
        return ':' + line;
      }
    }
    std::this_thread::sleep_for(kPause);
  }
  throw std::runtime_error("Xvfb does not start: " + server.output());
}

}  // namespace

BackgroundProgram::BackgroundProgram(std::vector<std::string> command,
                                     const std::vector<std::string>& environment,
                                     const std::filesystem::path& output)
    : child_(fork()), output_(output) {
  if (child_ == 0) {
    becomeProgram(command, environment, output);
  }
}

BackgroundProgram::~BackgroundProgram() {
  if (child_ > 0) {
    kill(child_, SIGKILL);
    waitpid(child_, nullptr, 0);
  }
}

int BackgroundProgram::exitCode() {
  int status = 0;
  waitpid(child_, &status, 0);
  child_ = 0;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

void BackgroundProgram::signal(int number) const { kill(child_, number); }

std::string BackgroundProgram::output() const { return contentOf(output_); }

// Without "-r" a key that a busy machine releases late repeats, as if it were held.
Desktop::Desktop()
    : server_({"Xvfb", "-r", "-displayfd", "1", "-screen", "0", "1280x720x24", "-nolisten", "tcp"},
              {}, folder_ / "xvfb.log") {
  display_ = awaitDisplay(server_);
}

std::string Desktop::run(const std::string& command) const {
  const std::string line = fmt::format("DISPLAY={} {} 2>&1", display_, command);
  FILE* pipe = popen(line.c_str(), "r");
  std::string text;
  std::array<char, 256> buffer{};
  while (fgets(buffer.data(), buffer.size(), pipe) != nullptr) {
    text += buffer.data();
  }
  pclose(pipe);
  return text;
}

std::string Desktop::awaitWindow(const std::string& title) const {
  return run(fmt::format("timeout 30 xdotool search --sync --limit 1 --name '{}'", title));
}

void Desktop::press(const std::string& keys) const { run("xdotool key " + keys); }

void Desktop::click(int x, int y) const {
  run(fmt::format("xdotool mousemove {} {} sleep 0.2 mousedown 1 sleep 0.2 mouseup 1", x, y));
}

std::filesystem::path Desktop::screenshot(const std::string& name) const {
  const std::filesystem::path file = folder_ / (name + ".png");
  run(fmt::format("import -window root {}", file.string()));
  return file;
}

}  // namespace morphgrid
