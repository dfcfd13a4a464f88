#include "app/propose_files.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include "app/draw_preview.h"
#include "app/output_files.h"
#include "app/proposal_text.h"
#include "app/try_design.h"
#include "core/atomic_file.h"
#include "core/create_folder.h"
#include "core/interrupt.h"
#include "core/output_error.h"
#include "core/read_file.h"
#include "print/print_material.h"
#include "propose/propose_scene.h"
#include "surface/load_mesh.h"

namespace morphgrid {
namespace {

/// A line on a terminal that is written over; elsewhere nothing.
class ProposalLine {
 public:
  explicit ProposalLine(bool isQuiet) : isShown_(!isQuiet && isatty(STDERR_FILENO) != 0) {}
  ~ProposalLine() {
    if (isShown_) fmt::print(stderr, "\r\033[K");
  }
  ProposalLine(const ProposalLine&) = delete;
  ProposalLine& operator=(const ProposalLine&) = delete;

  void tell(const std::string& what) const {
    if (!isShown_) return;
    fmt::print(stderr, "\r\033[K{}", what);
    std::fflush(stderr);
  }

 private:
  bool isShown_;
};

/// NAME_before.toml, or the first of NAME_before_2.toml, ... that is not there yet.
std::filesystem::path placeForWhatWasThere(const std::filesystem::path& file) {
  std::filesystem::path before = file;
  const std::string stem = file.stem().string() + "_before";
  before.replace_filename(stem + file.extension().string());
  for (int n = 2; std::filesystem::exists(before); ++n) {
    before.replace_filename(fmt::format("{}_{}{}", stem, n, file.extension().string()));
  }
  return before;
}

/// What people have changed is not lost.
void writeKeeping(const std::filesystem::path& file, const std::string& text) {
  if (std::filesystem::exists(file) && readFile(file) != text) {
    const std::filesystem::path before = placeForWhatWasThere(file);
    writeFileAtomically(before, readFile(file));
    spdlog::warn("{} is written anew; what was there is kept in {}", file.string(),
                 before.string());
  }
  writeFileAtomically(file, text);
}

std::filesystem::path seenFrom(const std::filesystem::path& folder,
                               const std::filesystem::path& file) {
  std::error_code failed;
  const auto relative = std::filesystem::relative(file, folder, failed);
  return failed || relative.empty() ? std::filesystem::absolute(file) : relative;
}

/// Without a device that draws there is none, and a line says so.
void drawSides(const SceneProposal& proposal, const std::filesystem::path& file) {
  std::vector<PreviewSide> sides = previewSides(proposal.sights);
  const Sight& chosen = proposal.placement.sight;
  std::erase_if(sides, [&](const PreviewSide& side) { return side.sight.name == chosen.name; });
  sides.insert(sides.begin(), {chosen, proposal.seen,
                               fmt::format("chosen, {}: {:.0f} % of the surface", chosen.name,
                                           100 * proposal.share)});
  try {
    drawPreview(file, proposal.request.mesh.filename().string(), proposal.look, sides);
  } catch (const DeviceError& error) {
    spdlog::warn("no {}: {}", file.string(), error.what());
  }
}

}  // namespace

ProposedFiles proposeFiles(const ProposalRequest& request, std::filesystem::path folder,
                           bool isQuiet) {
  const std::string name = request.mesh.stem().string();
  if (folder.empty()) folder = std::filesystem::path("out") / name;
  ProposedFiles files{folder / (name + ".toml"), {}, false, {}};
  {
    const ProposalLine line(isQuiet);
    files.proposal = proposeScene(
        request, tryDesign,
        {Cancellation(interruptRequested), [&](const std::string& what) { line.tell(what); }});
  }
  createFolder(folder, "--out " + folder.string());
  const std::string configuration = name + "_mesh.toml";
  for (auto file : {&ProposalRequest::printerFile, &ProposalRequest::materialFile}) {
    std::filesystem::path& named = files.proposal.request.*file;
    if (!named.empty()) named = seenFrom(folder, named);
  }
  OutputFiles output(folder, true);
  output.write(configuration, [&](const auto& file) {
    writeKeeping(file, proposalMeshText(files.proposal, seenFrom(folder, request.mesh)));
  });
  output.writeAt(files.scene, [&](const auto& file) {
    writeKeeping(file, proposalSceneText(files.proposal, configuration));
  });
  files.hasScene = output.lost().empty();
  output.write(kPreviewFile, [&](const auto& file) { drawSides(files.proposal, file); });
  files.lost = output.lost();
  return files;
}

void tellProposal(const ProposedFiles& files) {
  fmt::print("{}scene in {}, the sides in {}\n", proposalSummary(files.proposal),
             files.scene.string(), (files.scene.parent_path() / kPreviewFile).string());
  std::fflush(stdout);
}

void setMaterialFile(ProposalRequest& request, const std::filesystem::path& file) {
  const PrintMaterial material = readPrintMaterial(file);
  request.shrink = {-material.across.change, -material.along.change};
  request.materialFile = file;
}

std::filesystem::path proposedScene(const ProposalRequest& request,
                                    const std::filesystem::path& folder, bool isQuiet) {
  const ProposedFiles files = proposeFiles(request, folder, isQuiet);
  const std::string lost = fmt::format("{}", fmt::join(files.lost, "\n"));
  if (!files.hasScene) throw OutputError(lost);
  if (!lost.empty()) spdlog::warn(lost);
  if (!isQuiet) {
    tellProposal(files);
  }
  return files.scene;
}

std::filesystem::path sceneFor(const std::filesystem::path& argument,
                               const std::filesystem::path& folder, bool isQuiet) {
  return isMeshName(argument) ? proposedScene({.mesh = argument}, folder, isQuiet) : argument;
}

}  // namespace morphgrid
