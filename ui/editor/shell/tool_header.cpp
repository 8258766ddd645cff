#include "ui/editor/shell/tool_header.h"

#include <imgui.h>
#include <algorithm>

#include "ui/editor/shell/toolbar.h"
#include "ui/window/icons.h"
#include "ui/window/theme.h"
#include "ui/window/widgets.h"

namespace kerf {

namespace {

// clang-format off
const std::vector<HeaderLayout> kHeaders{
    {kLaserTool, {{"laser.radius"}, {"laser.size"}, {"laser.rim"}}},
    {kKnifeTool, {{"knife.shape"}, {"section.cut", "Cut at Section Plane"}}},
    {kPathTool,
     {{"path.speed"}, {"path.resolution"}, {"path.run", "Run"}, {"path.delete_point", "Delete Point"},
      {"path.clear", "Clear"}}},
    {kDrawingTool,
     {{"drawing.mode"}, {"drawing.cut", "Cut"}, {"drawing.cancel", "Remove"}, {"drawing.width"},
      {"drawing.turn"}, {"drawing.with"}}},
    {kPickTool,
     {{"pieces.shape"}, {"pieces.select_body", "Connected"}, {"pieces.select_material", "Material"},
      {"pieces.select_similar", "Similar Area"}, {"pieces.grow", "Grow"}, {"pieces.shrink", "Shrink"},
      {"pieces.invert", "Invert"}}},
    {kInspectTool, {{"measure.kind"}}},
    {kRulerTool, {{"ruler.kind"}, {"ruler.undo", "Undo"}, {"ruler.redo", "Redo"}, {"ruler.export", "Export..."}}},
};
// clang-format on

constexpr float kHeaderMarginEms = 0.5f, kItemGapEms = 1, kLabelEms = 5;
constexpr float kMinWidthEms = 40, kMinHeightEms = 24;  // of the viewport
constexpr float kAxesEms = 9;                           // width of the axes gizmo at the right

float width_of_button(const char* label) {
  return ImGui::CalcTextSize(label).x + 2 * ImGui::GetStyle().FramePadding.x;
}

void draw_button(const HeaderItem& item, const UserAction& action) {
  const char* disabled_reason = action.objection();
  ImGui::BeginDisabled(disabled_reason != nullptr);
  if (ImGui::Button(item.label)) action.run();
  ImGui::EndDisabled();
  mark_last_item(item.id);
  tooltip(disabled_reason != nullptr ? disabled_reason : action.tip.c_str());
}

void draw_option(const ToolOption& option) {
  ImGui::BeginGroup();
  ImGui::PushID(option.id);
  ImGui::PushItemWidth(option.width_ems * ImGui::GetFontSize());
  option.draw();
  ImGui::PopItemWidth();
  ImGui::PopID();
  ImGui::EndGroup();
  mark_last_item(option.id);
}

void draw_name(const UserAction& action) {
  const float em = ImGui::GetFontSize(), height = ImGui::GetFrameHeight();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const auto icon = icon_of_tool(action.id);
  if (icon)
    draw_icon(*icon, *ImGui::GetWindowDrawList(), {at.x + 0.6f * em, at.y + 0.5f * height}, 0.5f * em,
              colours::accent());
  ImGui::SetCursorScreenPos({at.x + (icon ? 1.6f : 0.4f) * em, at.y});
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(action.name.c_str());
}

}  // namespace

std::span<const HeaderLayout> header_layout() { return kHeaders; }

void ToolHeader::gather(const Features& features) {
  for (const auto& feature : features) {
    for (ToolOption& option : feature->tool_options()) options_.emplace(option.id, option);
  }
}

void ToolHeader::draw_items(const HeaderLayout& header, float right,
                            std::span<const UserAction> actions) const {
  const float em = ImGui::GetFontSize();
  for (const HeaderItem& item : header.items) {
    const auto option = options_.find(item.id);
    const UserAction* action = item.label != nullptr ? find_action(actions, item.id) : nullptr;
    if (action == nullptr && (option == options_.end() || !option->second.is_shown())) continue;
    const float width =
        action != nullptr ? width_of_button(item.label) : (option->second.width_ems + kLabelEms) * em;
    const float gap = (action != nullptr && &item != &header.items.front() ? 0.5f : 1) * kItemGapEms * em;
    ImGui::SameLine(0, gap);
    if (ImGui::GetCursorScreenPos().x + width > right) return;
    action != nullptr ? draw_button(item, *action) : draw_option(option->second);
  }
}

Area ToolHeader::draw(const Layout& layout, const std::string& tool,
                      std::span<const UserAction> actions) const {
  const float em = ImGui::GetFontSize();
  const Area& viewport = layout.viewport;
  const auto header = std::ranges::find_if(kHeaders, [&](const HeaderLayout& h) { return h.tool == tool; });
  const UserAction* action = find_action(actions, "tool." + tool);
  if (header == kHeaders.end() || action == nullptr || layout.split()) return {viewport.at, Vec2(0)};
  if (viewport.size.x < kMinWidthEms * em || viewport.size.y < kMinHeightEms * em)
    return {viewport.at, Vec2(0)};
  const ImVec2 at = to_im(viewport.at + Vec2(kHeaderMarginEms * em));
  Area covered{viewport.at, Vec2(0)};
  ImGui::SetNextWindowPos(at);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.4f * em, 0.25f * em});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 4);
  if (ImGui::Begin("##header", nullptr, kOverlayBar)) {
    prefix_landmarks("header ");
    draw_name(*action);
    draw_items(*header, static_cast<float>(viewport.at.x + viewport.size.x) - kAxesEms * em, actions);
    const ImVec2 size = ImGui::GetWindowSize();
    covered.size = Vec2(size.x, size.y) + Vec2(kHeaderMarginEms * em);
    mark_area("bar", {{at.x, at.y}, {size.x, size.y}});
    prefix_landmarks("");
  }
  ImGui::End();
  ImGui::PopStyleVar(2);
  return covered;
}

}  // namespace kerf
