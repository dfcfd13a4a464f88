#include "view/overlay.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "render/scale_bar.h"

namespace morphgrid {
namespace {

constexpr ImU32 kOverlayInk = IM_COL32(40, 44, 52, 255);
constexpr ImU32 kMarkInk = IM_COL32(220, 0, 200, 255);
constexpr float kMargin = 18;  // Pixels, as all below.
constexpr float kBarWidth = 200;
constexpr float kBarHeight = 12;
constexpr float kAxisLength = 34;
constexpr int kBarSteps = 64;

ImVec2 corner(const SceneArea& area, float right, float bottom) {
  return {static_cast<float>(area.left + area.width) - right,
          static_cast<float>(area.top + area.height) - bottom};
}

ImU32 colorOf(const glm::vec3& color) {
  return ImGui::ColorConvertFloat4ToU32({color.x, color.y, color.z, 1});
}

void writeCentred(float x, float y, const std::string& text) {
  const float width = ImGui::CalcTextSize(text.c_str()).x;
  ImGui::GetBackgroundDrawList()->AddText({x - width / 2, y}, kOverlayInk, text.c_str());
}

}  // namespace

void drawLegend(const Legend& legend, const SceneArea& area) {
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const float line = ImGui::GetTextLineHeight();
  const ImVec2 from = corner(area, kBarWidth + 2 * kMargin, kMargin + kBarHeight + 2 * line);
  for (int n = 0; n < kBarSteps; ++n) {
    const float left = from.x + kBarWidth * static_cast<float>(n) / kBarSteps;
    list.AddRectFilled({left, from.y}, {left + kBarWidth / kBarSteps + 0.5F, from.y + kBarHeight},
                       colorOf(legend.colorAt((n + 0.5) / kBarSteps)));
  }
  writeCentred(from.x + kBarWidth / 2, from.y - line - 3, legend.title);
  for (const LegendMark& mark : legend.marks) {
    const float x = from.x + kBarWidth * static_cast<float>(mark.place);
    writeCentred(x, from.y + kBarHeight + 2, mark.text);
    writeCentred(x, from.y + kBarHeight + 2 + line, mark.secondLine);
  }
}

void drawAxes(const Camera& camera, const SceneArea& area) {
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const ImVec2 from(static_cast<float>(area.left) + 2.5F * kMargin,
                    corner(area, 0, 2.5F * kMargin).y);
  constexpr std::array<const char*, 3> names = {"x", "y", "z"};
  constexpr std::array<ImU32, 3> colors = {IM_COL32(200, 40, 40, 255), IM_COL32(40, 140, 40, 255),
                                           IM_COL32(50, 80, 210, 255)};
  for (int axis = 0; axis < 3; ++axis) {
    const auto x = static_cast<float>(camera.viewFromWorld[axis][0]);
    const auto y = static_cast<float>(-camera.viewFromWorld[axis][1]);
    const ImVec2 to(from.x + kAxisLength * x, from.y + kAxisLength * y);
    list.AddLine(from, to, colors[axis], 2);
    list.AddText({to.x + 6 * x - 4, to.y + 6 * y - 8}, colors[axis], names[axis]);
  }
}

void drawScaleBar(const Camera& camera, const Eigen::Vector3d& pivot, const SceneArea& area) {
  const auto bar = scaleBarAt(camera, pivot, area.height, kBarWidth, {});
  if (!bar) {
    return;
  }
  const auto width = static_cast<float>(bar->pixels);
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const float y = corner(area, 0, kMargin).y;
  const float left = static_cast<float>(area.left) + 6 * kMargin;
  list.AddLine({left, y}, {left + width, y}, kOverlayInk, 2);
  for (const float x : {left, left + width}) {
    list.AddLine({x, y - 5}, {x, y + 5}, kOverlayInk, 2);
  }
  writeCentred(left + width / 2, y - 8 - ImGui::GetTextLineHeight(), bar->text);
}

void drawMark(const Camera& camera, const Eigen::Vector3d& from, const Eigen::Vector3d& to,
              const SceneArea& area) {
  const auto a = pixelOf(from, camera.clipFromWorld(), area);
  const auto b = pixelOf(to, camera.clipFromWorld(), area);
  if (a && b) {
    const auto toScreen = [](const glm::dvec2& p) {
      return ImVec2(static_cast<float>(p.x), static_cast<float>(p.y));
    };
    ImGui::GetBackgroundDrawList()->AddLine(toScreen(*a), toScreen(*b), kMarkInk, 5);
  }
}

}  // namespace morphgrid
