#include "benchmark/validation.h"

#include <fmt/format.h>

#include <iostream>
#include <memory>

#include "benchmark/validation_tables.h"
#include "core/atomic_file.h"
#include "core/interrupt.h"
#include "core/read_file.h"
#include "report/generated_block.h"

namespace morphgrid {
namespace {

struct ValidationOptions {
  std::filesystem::path references = "tests/solve/frames";
  std::filesystem::path document = "docs/validation.md";
  std::string selection;
};

void run(const ValidationOptions& options) {
  installInterruptHandler();
  const Device device({.selection = options.selection, .validation = false});
  std::string document = readFile(options.document);
  const auto write = [&](const char* block, const std::string& table) {
    fmt::print("{}\n\n{}\n", block, table);
    std::cout.flush();
    if (interruptRequested()) {
      throw std::runtime_error("interrupted");
    }
    document = withBlock(document, block, table);
  };
  write("device", fmt::format("Measured on {}.\n", device.name()));
  write("circle", circleTable());
  write("ladder", ladderTable(device));
  write("oracles", oracleTable(device, options.references));
  write("solid ladders", solidLadderTable(device, options.references));
  write("solids", solidTable(device, options.references));
  write("subdivision", subdivisionTable(options.references));
  write("invariance", invarianceTable(device, options.references));
  writeFileAtomically(options.document, document);
}

}  // namespace

void addValidation(CLI::App& app) {
  const auto options = std::make_shared<ValidationOptions>();
  CLI::App* command = app.add_subcommand(
      "validate", "Sets frames beside closed forms, an independent solver and solids that grow.");
  command->add_option("--references", options->references, "folder of what they are compared with")
      ->capture_default_str();
  command->add_option("--document", options->document, "whose tables are written anew")
      ->capture_default_str();
  command->add_option("--device", options->selection,
                      "index or part of the name of a Vulkan device");
  command->callback([options] { run(*options); });
}

}  // namespace morphgrid
