#include "app/command_end.h"
#include "app/command_options.h"
#include "app/commands.h"
#include "app/propose_files.h"
#include "core/error.h"

namespace morphgrid {
namespace {

struct NewArguments {
  ProposalRequest request;
  std::filesystem::path folder;
  std::vector<double> shrinkPercent;
  bool isQuiet = false;
};

int propose(const NewArguments& arguments) {
  ProposalRequest request = arguments.request;
  if (!arguments.shrinkPercent.empty()) {
    request.shrink = {arguments.shrinkPercent[0] / 100, arguments.shrinkPercent[1] / 100};
    if (request.shrink.least >= request.shrink.most) {
      throw InputError("--material LEAST MOST: the least must be less than the most");
    }
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
  command->add_option("--size", request.size, "longer side of what is printed, in mm [100]")
      ->type_name("MM")
      ->check(CLI::PositiveNumber);
  command->add_option("--nodes", request.nodesLong, "nodes along the longer side [20]")
      ->check(CLI::Range(4, 1000));
  command
      ->add_option("--material", arguments->shrinkPercent,
                   "what printed struts lose of their length at the least and at the most, in % "
                   "[2 40, as PLA does]")
      ->type_name("LEAST MOST")
      ->expected(2)
      ->check(CLI::Range(-99.0, 99.0));
  command->add_flag("--paper", request.isPapers, "the paper's design: springs, lengths by formula");
  addQuietFlag(*command, arguments->isQuiet);
  command->callback([&action, arguments] { action = [=] { return propose(*arguments); }; });
}

}  // namespace morphgrid
