#include "ui/editor/shell/toolbar.h"

#include <algorithm>
#include <array>

#include "ui/editor/shell/catalogue.h"
#include "ui/window/theme.h"
#include "ui/window/widgets.h"

namespace kerf {

namespace {

struct Tool {
  const char* action;
  Icon icon;
  bool begins_group = false;
};
constexpr std::array kTools{
    Tool{"tool.laser", Icon::kLaser},        Tool{"tool.knife", Icon::kKnife},
    Tool{"tool.path", Icon::kPath},          Tool{"emitter.place", Icon::kEmitter},
    Tool{"tool.pick", Icon::kPointer, true}, Tool{"pieces.move", Icon::kMove},
    Tool{"pieces.rotate", Icon::kRotate},    Tool{"tool.inspect", Icon::kCallipers, true},
    Tool{"tool.ruler", Icon::kRuler},        Tool{"view.section", Icon::kSection}};
constexpr float kButtonEms = 2.1f, kGapEms = 0.5f, kPaddingEms = 0.25f;

std::string tip_of(const UserAction& action) {
  std::string tip = action.name;
  if (!action.shortcut.empty()) tip += " (" + action.shortcut + ")";
  const char* disabled_reason = action.objection();
  return tip + "\n" + (disabled_reason != nullptr ? disabled_reason : action.tip);
}

void draw_tool(const Tool& tool, const UserAction& action) {
  const float size = kButtonEms * ImGui::GetFontSize();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const bool disabled = action.objection() != nullptr, lit = action.checked && action.checked();
  if (ImGui::InvisibleButton(tool.action, {size, size}) && !disabled) action.run();
  mark_last_item(tool.action);
  const bool over = ImGui::IsItemHovered();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (lit || (over && !disabled))
    list.AddRectFilled(at, {at.x + size, at.y + size},
                       ImGui::GetColorU32(lit ? ImGuiCol_FrameBgActive : ImGuiCol_FrameBgHovered), 3);
  const ImU32 colour = disabled ? ImGui::GetColorU32(ImGuiCol_TextDisabled, 0.5f)
                       : lit    ? colours::accent()
                                : colours::text();
  draw_icon(tool.icon, list, {at.x + 0.5f * size, at.y + 0.5f * size}, 0.27f * size, colour);
  tooltip(tip_of(action).c_str());
}

}  // namespace

std::optional<Icon> icon_of_tool(const std::string& action) {
  for (const Tool& tool : kTools) {
    if (action == tool.action) return tool.icon;
  }
  return std::nullopt;
}

Area toolbar_area(const Area& viewport) {
  const double em = ImGui::GetFontSize();
  const auto groups = std::ranges::count_if(kTools, [](const Tool& tool) { return tool.begins_group; });
  const Vec2 size =
      em * Vec2(kButtonEms + 2 * kPaddingEms,
                kTools.size() * kButtonEms + static_cast<double>(groups) * kGapEms + 2 * kPaddingEms);
  if (viewport.size.y < size.y + 8.5 * em) return {viewport.at, Vec2(0)};
  return {viewport.at + Vec2(kGapEms * em, 0.5 * (viewport.size.y - size.y)), size};
}

void draw_toolbar(const Area& viewport, std::span<const UserAction> actions) {
  const Area area = toolbar_area(viewport);
  if (area.size.x == 0) return;
  const float em = ImGui::GetFontSize();
  ImGui::SetNextWindowPos(to_im(area.at));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {kPaddingEms * em, kPaddingEms * em});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 4);
  if (ImGui::Begin("##toolbar", nullptr, kOverlayBar)) {
    for (const Tool& tool : kTools) {
      if (tool.begins_group) ImGui::Dummy({0, kGapEms * em});
      if (const UserAction* action = find_action(actions, tool.action)) draw_tool(tool, *action);
    }
  }
  ImGui::End();
  ImGui::PopStyleVar(3);
}

}  // namespace kerf
