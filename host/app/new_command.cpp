#include "app/command_end.h"
#include "app/command_options.h"
#include "app/commands.h"
#include "app/propose_files.h"
#include "core/error.h"
#include "print/printer.h"

namespace morphgrid {
namespace {

struct NewArguments {
  ProposalRequest request;
  std::filesystem::path folder;
  std::vector<std::string> material;  ///< A file, or two numbers in %.
  bool isQuiet = false;
};

double percentOf(const std::string& text) {
  double percent = 0;
  if (!CLI::detail::lexical_cast(text, percent) || !(percent >= -99 && percent <= 99)) {
    throw InputError("--material: " + text +
                     " must be a number from -99 to 99, in %; or name a material file");
  }
  return percent;
}

void readMaterialInto(ProposalRequest& request, const std::vector<std::string>& material) {
  if (material.size() == 1) {
    setMaterialFile(request, material.front());
  } else if (material.size() == 2) {
    request.shrink = {percentOf(material[0]) / 100, percentOf(material[1]) / 100};
    if (request.shrink.least >= request.shrink.most) {
      throw InputError("--material LEAST MOST: the least must be less than the most");
    }
  }
}

int propose(const NewArguments& arguments) {
  ProposalRequest request = arguments.request;
  readMaterialInto(request, arguments.material);
  if (!request.printerFile.empty()) {
    if (request.materialFile.empty()) {
      throw InputError("--printer needs --material FILE, what it prints with");
    }
    readPrinter(request.printerFile);  // Its faults are told before the mesh is looked at.
  }
  const ProposedFiles files = proposeFiles(request, arguments.folder, arguments.isQuiet);
  if (!arguments.isQuiet) tellProposal(files);
  tellLostFiles(files.lost);
  return files.lost.empty() ? kConverged : kOutputLost;
}

}  // namespace

void addNewCommand(CLI::App& app, Action& action) {
  const auto arguments = std::make_shared<NewArguments>();
  ProposalRequest& request = arguments->request;
  CLI::App* command = app.add_subcommand(
      "new", "look at a mesh and write a scene for it, with a reason for each choice");
  command->add_option("FILE", request.mesh, "mesh: OBJ, STL, PLY, glTF or GLB")->required();
  command->add_option("--out", arguments->folder, "folder of the scene [out/FILE]");
  command
      ->add_option("--size", request.size,
                   "longer side of the part of the mesh that is taken, in mm [100; with --printer "
                   "as large as fits]")
      ->type_name("MM")
      ->check(within(aboveUpTo(0, 1e6)));
  command->add_option("--nodes", request.nodesLong, "nodes along the longer side [20]")
      ->check(CLI::Range(4, 1000));
  command
      ->add_option("--material", arguments->material,
                   "a material file, e.g. materials/pla_0.08.toml; or what printed struts lose of "
                   "their length at the least and at the most, in % [2 40, as PLA does]")
      ->type_name("FILE | LEAST MOST")
      ->expected(1, 2);
  command->add_option("--printer", request.printerFile,
                      "a printer file, e.g. printers/prusa_mk4.toml: the scene then has a [print]");
  command->add_flag("--paper", request.isPapers, "the paper's design: springs, lengths by formula");
  addQuietFlag(*command, arguments->isQuiet);
  command->callback([&action, arguments] { action = [=] { return propose(*arguments); }; });
}

}  // namespace morphgrid
