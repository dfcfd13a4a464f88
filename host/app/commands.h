#pragma once
#include <functional>

namespace CLI {
class App;
}

namespace morphgrid {

/// What the program does once its command line is read. Returns an ExitCode; throws as functions of
/// the pipeline do.
using Action = std::function<int()>;

// Each adds one subcommand, with its options; where the user gives it, `action` becomes what it
// does. Keeps a reference to `action`.
void addNewCommand(CLI::App& app, Action& action);
void addRunCommand(CLI::App& app, Action& action);
void addCheckCommand(CLI::App& app, Action& action);
void addFiguresCommand(CLI::App& app, Action& action);
void addPrintCommand(CLI::App& app, Action& action);
void addCalibrateCommand(CLI::App& app, Action& action);
void addViewCommand(CLI::App& app, Action& action);
void addDevicesCommand(CLI::App& app, Action& action);

}  // namespace morphgrid
