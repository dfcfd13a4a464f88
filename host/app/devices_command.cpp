#include <fmt/format.h>

#include "app/command_end.h"
#include "app/command_options.h"
#include "app/commands.h"

namespace morphgrid {
namespace {

int printDevices() {
  int index = 0;
  for (const DeviceSummary& device : listDevices()) {
    fmt::print("{}  {} ({}, Vulkan {})\n", index++, device.name, device.type, device.apiVersion);
  }
  return kConverged;
}

}  // namespace

void addDevicesCommand(CLI::App& app, Action& action) {
  app.add_subcommand("devices", "list the Vulkan devices")->callback([&action] {
    action = printDevices;
  });
}

}  // namespace morphgrid
