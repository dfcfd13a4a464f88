#include "view/panels.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "energy/bar_state.h"
#include "grid/bar_section.h"

namespace morphgrid {
namespace {

const ImVec4 kWarning{0.75F, 0.25F, 0.0F, 1};
constexpr double kDegreesPerRadian = 180 / std::numbers::pi;
constexpr float kPlotHeight = 46;  // Pixels.
constexpr float kStrutStyleWidth = 120;
constexpr float kMessageWidth = 480;
constexpr float kStatusLines = 2;
constexpr const char* kAutomatic = "automatic";
constexpr const char* kHelp =
    "Drag with the left button: turn.  Right button or Shift: move.  Wheel: nearer, farther.\n"
    "Click a strut: its numbers.\n\n"
    "1 to 7     target, sampling, initial, in-plane, stacked, warped, surface\n"
    "0          what the run has reached\n"
    "C, T       next colour; target over the result\n"
    "S          struts as lines, ribbons, tubes, or as fine as frames allow\n"
    "Space, N   pause or go on; one step\n"
    "R          start again, from flat\n"
    "F          all of it\n"
    "O, X, Y, Z from the front and above; along +x (the paper's), +y; from above\n"
    "arrows, + -   turn, nearer, farther\n"
    "Tab, H     panels; this help\n"
    "Ctrl+Z, Ctrl+Shift+Z   undo, redo a knob\n"
    "Ctrl+S, Ctrl+E, Ctrl+P save the scene, export the result's files, save a picture\n"
    "Ctrl+R     read the scene file again\n"
    "Ctrl+Q     close";

void drawMenu(const Snapshot& snapshot, ViewState& state, Session& session,
              const WindowActions& actions) {
  if (!ImGui::BeginMenuBar()) {
    return;
  }
  if (ImGui::BeginMenu("File")) {
    if (ImGui::MenuItem("Save scene", "Ctrl+S")) session.saveScene();
    if (ImGui::MenuItem("Export files", "Ctrl+E")) session.exportFiles();
    if (ImGui::MenuItem("Save picture", "Ctrl+P")) actions.savePicture();
    if (ImGui::MenuItem("Reload scene file", "Ctrl+R")) session.reload();
    ImGui::EndMenu();
  }
  if (ImGui::BeginMenu("Edit")) {
    if (ImGui::MenuItem("Undo", "Ctrl+Z", false, snapshot.canUndo)) session.undo();
    if (ImGui::MenuItem("Redo", "Ctrl+Shift+Z", false, snapshot.canRedo)) session.redo();
    ImGui::EndMenu();
  }
  if (ImGui::BeginMenu("View")) {
    if (ImGui::MenuItem("Show all", "F")) actions.frameAll();
    ImGui::MenuItem("Keys", "H", &state.showsHelp);
    ImGui::EndMenu();
  }
  ImGui::EndMenuBar();
}

void drawRunButtons(ViewState& state, Session& session) {
  if (ImGui::Button(state.isPaused ? "Go on" : "Pause")) {
    state.isPaused = !state.isPaused;
    session.pause(state.isPaused);
  }
  ImGui::SameLine();
  if (ImGui::Button("One step")) {
    state.isPaused = true;
    session.step();
  }
  ImGui::SameLine();
  if (ImGui::Button("Start again")) {
    session.restart();
  }
  ImGui::SameLine();
  if (ImGui::Checkbox("Show every step", &state.showsEveryStep)) {
    session.showEveryStep(state.showsEveryStep);
  }
}

/// The common logarithms of a figure of every sample.
void plot(const char* label, const std::vector<ConvergenceSample>& history,
          double ConvergenceSample::*figure) {
  std::vector<float> values;
  values.reserve(history.size());
  for (const ConvergenceSample& sample : history) {
    values.push_back(static_cast<float>(std::log10(std::max(sample.*figure, 1e-300))));
  }
  const std::string text =
      values.empty() ? std::string(label) : fmt::format("{} {:.3g}", label, history.back().*figure);
  ImGui::PlotLines("##plot", values.data(), static_cast<int>(values.size()), 0, text.c_str(),
                   FLT_MAX, FLT_MAX, {ImGui::GetContentRegionAvail().x, kPlotHeight});
}

void drawRun(const Snapshot& snapshot, ViewState& state, Session& session) {
  // Always as high: controls below would move under the mouse.
  ImGui::BeginChild("status", {0, kStatusLines * ImGui::GetTextLineHeightWithSpacing()});
  ImGui::TextWrapped("%s", snapshot.status.c_str());
  ImGui::EndChild();
  drawRunButtons(state, session);
  ImGui::PushID("residual");
  plot("residual", snapshot.history, &ConvergenceSample::residual);
  ImGui::PopID();
  ImGui::PushID("energy");
  plot("energy", snapshot.history, &ConvergenceSample::energy);
  ImGui::PopID();
}

/// Beside the panel: there, what comes and goes would move the controls under the mouse.
void drawMessages(const Snapshot& snapshot, int windowHeight) {
  if (!snapshot.problem && !snapshot.isOutdated && snapshot.message.empty()) {
    return;
  }
  ImGui::SetNextWindowPos({kPanelWidth + 16, static_cast<float>(windowHeight) - 16},
                          ImGuiCond_Always, {0, 1});
  ImGui::Begin("Messages", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                   ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoNav |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing);
  ImGui::PushTextWrapPos(kMessageWidth);
  ImGui::PushStyleColor(ImGuiCol_Text, kWarning);
  if (snapshot.problem) {
    ImGui::TextUnformatted(snapshot.problem->c_str());
  }
  if (snapshot.isOutdated) {
    ImGui::TextUnformatted("A file of the scene has changed: Ctrl+R reads it again.");
  }
  ImGui::PopStyleColor();
  if (!snapshot.message.empty()) {
    ImGui::TextUnformatted(snapshot.message.c_str());
  }
  ImGui::PopTextWrapPos();
  ImGui::End();
}

void drawStageChoice(const Snapshot& snapshot, ViewState& state) {
  const ShownStage current = stageOf(state, snapshot);
  if (ImGui::RadioButton("newest", !state.stage)) {
    state.stage.reset();
  }
  for (std::size_t n = 0; n < kStageNames.size(); ++n) {
    if (n % 4 != 3) {
      ImGui::SameLine();
    }
    ImGui::BeginDisabled(!snapshot.has(static_cast<ShownStage>(n)));
    if (ImGui::RadioButton(kStageNames[n], state.stage && static_cast<std::size_t>(current) == n)) {
      state.stage = static_cast<ShownStage>(n);
    }
    ImGui::EndDisabled();
  }
}

void drawStrutStyleChoice(ViewState& state) {
  const char* current =
      state.strutStyle ? kStrutStyleNames[static_cast<std::size_t>(*state.strutStyle)] : kAutomatic;
  if (ImGui::BeginCombo("struts", current)) {
    if (ImGui::Selectable(kAutomatic, !state.strutStyle)) {
      state.strutStyle.reset();
    }
    for (std::size_t n = 0; n < kStrutStyleNames.size(); ++n) {
      const auto style = static_cast<StrutStyle>(n);
      if (ImGui::Selectable(kStrutStyleNames[n], state.strutStyle == style)) {
        state.strutStyle = style;
      }
    }
    ImGui::EndCombo();
  }
}

/// Those that cannot be had say why.
void drawColoringChoice(const Snapshot& snapshot, ViewState& state) {
  const auto& shown = gridOf(stageOf(state, snapshot), snapshot);
  if (!ImGui::BeginCombo("colours", kColoringNames[static_cast<std::size_t>(state.coloring)],
                         ImGuiComboFlags_HeightLargest)) {
    return;
  }
  for (std::size_t n = 0; n < kColoringNames.size(); ++n) {
    const auto coloring = static_cast<Coloring>(n);
    const std::string missing = shown ? whatIsMissing(coloring, *shown, snapshot) : "";
    const std::string label =
        missing.empty() ? kColoringNames[n] : fmt::format("{}: {}", kColoringNames[n], missing);
    const auto flags = missing.empty() ? ImGuiSelectableFlags_None : ImGuiSelectableFlags_Disabled;
    if (ImGui::Selectable(label.c_str(), state.coloring == coloring, flags)) {
      state.coloring = coloring;
    }
  }
  ImGui::EndCombo();
}

void drawLook(const Snapshot& snapshot, ViewState& state) {
  drawStageChoice(snapshot, state);
  drawColoringChoice(snapshot, state);
  ImGui::Checkbox("target over the result", &state.showsTarget);
  ImGui::SameLine();
  ImGui::SetNextItemWidth(kStrutStyleWidth);
  drawStrutStyleChoice(state);
}

/// The new value as the scene file has it, when the user has changed it.
std::optional<std::string> drawKnob(const Knob& knob) {
  if (!knob.choices.empty()) {
    int index = static_cast<int>(knob.value);
    const auto text = [](void* choices, int n, const char** out) {
      *out = (*static_cast<const std::vector<std::string>*>(choices))[n].c_str();
      return true;
    };
    auto choices = knob.choices;
    const bool changed =
        ImGui::Combo(knob.label.c_str(), &index, text, &choices, static_cast<int>(choices.size()));
    return changed ? std::optional(fmt::format("\"{}\"", knob.choices[index])) : std::nullopt;
  }
  if (knob.isBoolean) {
    bool value = knob.value != 0;
    const bool changed = ImGui::Checkbox(knob.label.c_str(), &value);
    return changed ? std::optional<std::string>(value ? "true" : "false") : std::nullopt;
  }
  if (knob.isInteger) {
    int value = static_cast<int>(knob.value);
    ImGui::InputInt(knob.label.c_str(), &value, 1, 10);
    const double within = std::clamp(static_cast<double>(value), knob.low, knob.high);
    return within == knob.value ? std::nullopt : std::optional(fmt::format("{:.0f}", within));
  }
  double value = knob.value;
  const int flags = knob.isLogarithmic ? ImGuiSliderFlags_Logarithmic : ImGuiSliderFlags_None;
  return ImGui::SliderScalar(knob.label.c_str(), ImGuiDataType_Double, &value, &knob.low,
                             &knob.high, "%.4g", flags)
             // Digits enough for any eye, few enough to read in a saved scene.
             ? std::optional(fmt::format("{:.5g}", value))
             : std::nullopt;
}

/// As TOML wants floating-point numbers: with a point or an exponent.
std::string toTomlNumber(const Knob& knob, const std::string& text) {
  const bool isWhole = text.find_first_of(".e\"") == std::string::npos;
  return isWhole && !knob.isInteger && !knob.isBoolean ? text + ".0" : text;
}

void drawKnobs(const Snapshot& snapshot, Session& session) {
  ImGui::PushItemWidth(190);
  for (const Knob& knob : snapshot.knobs) {
    if (const auto value = drawKnob(knob)) {
      session.turnKnob(knob.key, toTomlNumber(knob, *value));
    }
    if (ImGui::IsItemHovered()) {
      ImGui::SetTooltip("%s", knob.key.c_str());
    }
  }
  ImGui::PopItemWidth();
}

void drawBarNumbers(const ShownGrid& shown, const Strut& strut) {
  const BarState bar = barStateAt(*shown.grid, {*shown.positions, *shown.rotations}, strut);
  const Eigen::Array2d size = rectangleOf(shown.grid->bars->section(strut));
  ImGui::Text("width %.4g   height %.4g", size[0], size[1]);
  ImGui::Text("bending strain %.2f %%   joint rotation %.2f\u00b0", 100 * bar.bendingStrain,
              kDegreesPerRadian * bar.jointRotation);
}

void drawFigures(const Snapshot& snapshot) {
  ImGui::PushFont(ImGui::GetIO().Fonts->Fonts.back());
  const float height = ImGui::CalcTextSize(snapshot.figures.c_str()).y;
  ImGui::BeginChild("table", {0, height + 2 * ImGui::GetStyle().ScrollbarSize}, false,
                    ImGuiWindowFlags_HorizontalScrollbar);
  ImGui::TextUnformatted(snapshot.figures.c_str());
  ImGui::EndChild();
  ImGui::PopFont();
  for (const std::string& notice : snapshot.notices) {
    ImGui::PushStyleColor(ImGuiCol_Text, kWarning);
    ImGui::TextWrapped("%s", notice.c_str());
    ImGui::PopStyleColor();
  }
}

}  // namespace

void drawPanels(const Snapshot& snapshot, ViewState& state, Session& session,
                const WindowActions& actions, int windowHeight) {
  ImGui::SetNextWindowPos({0, 0});
  ImGui::SetNextWindowSize({kPanelWidth, static_cast<float>(windowHeight)});
  ImGui::Begin("morphgrid", nullptr,
               ImGuiWindowFlags_MenuBar | ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                   ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoNav);
  drawMenu(snapshot, state, session, actions);
  ImGui::TextUnformatted(snapshot.title.c_str());
  drawRun(snapshot, state, session);
  if (ImGui::CollapsingHeader("View", ImGuiTreeNodeFlags_DefaultOpen)) {
    drawLook(snapshot, state);
  }
  if (ImGui::CollapsingHeader("Knobs", ImGuiTreeNodeFlags_DefaultOpen)) {
    drawKnobs(snapshot, session);
  }
  if (ImGui::CollapsingHeader("Figures", ImGuiTreeNodeFlags_DefaultOpen)) {
    drawFigures(snapshot);
  }
  ImGui::End();
  drawMessages(snapshot, windowHeight);
}

void drawStrutNumbers(const Snapshot& snapshot, const ShownGrid& shown, const Strut& strut) {
  const GridShape& shape = shown.grid->shape;
  const double rest = valueAt(shown.grid->rest, strut);
  const double printed = lengthAt(shown.grid->positions, strut);
  const double present = lengthAt(*shown.positions, strut);
  const GridPlace place = shape.place(strut.from);
  constexpr std::array<const char*, 3> directions = {"u", "v", "w"};
  ImGui::SetNextWindowPos({kPanelWidth + 16, 16}, ImGuiCond_Appearing);
  ImGui::Begin("Strut", nullptr,
               ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoNav |
                   ImGuiWindowFlags_NoSavedSettings);
  ImGui::Text("along %s, from (%d, %d), layer %d of %d",
              directions[static_cast<std::size_t>(strut.direction)], place.i, place.j,
              place.layer + 1, shape.layers);
  ImGui::Text("rest %.6g   printed %.6g   now %.6g", rest, printed, present);
  ImGui::Text("strain %+.2f %%   shrink %.2f %%", 100 * (present - rest) / rest,
              100 * (1 - rest / printed));
  if (canColor(Coloring::bendingStrain, shown, snapshot)) {
    drawBarNumbers(shown, strut);
  }
  if (canColor(Coloring::angleError, shown, snapshot)) {
    const auto errorAt = [&](int joint) {
      return kDegreesPerRadian * (*snapshot.angleErrors)[shape.column(joint)];
    };
    ImGui::Text("printed angle error %.2f\u00b0 and %.2f\u00b0 at its joints", errorAt(strut.from),
                errorAt(strut.to));
  }
  for (const int end : {strut.from, strut.to}) {
    const Eigen::Vector3d at = shown.worldFromGrid * shown.positions->col(end);
    ImGui::Text("%s (%.5g, %.5g, %.5g)", end == strut.from ? "from" : "to  ", at.x(), at.y(),
                at.z());
  }
  ImGui::End();
}

void drawHelp(bool& isOpen) {
  ImGui::SetNextWindowPos({kPanelWidth + 16, 16}, ImGuiCond_Appearing);
  ImGui::Begin("Keys", &isOpen, ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoNav);
  ImGui::PushFont(ImGui::GetIO().Fonts->Fonts.back());
  ImGui::TextUnformatted(kHelp);
  ImGui::PopFont();
  ImGui::End();
}

}  // namespace morphgrid
