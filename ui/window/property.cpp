#include "ui/window/property.h"

#include <imgui.h>
#include <imgui_internal.h>

#include "core/base/assert.h"

namespace kerf {

namespace {
constexpr float kTooltipSeconds = 0.5f;
}

bool begin_properties(const char* id) {
  if (!ImGui::BeginTable(id, 2, ImGuiTableFlags_SizingStretchProp)) return false;
  ImGui::TableSetupColumn("label", ImGuiTableColumnFlags_WidthFixed, 5.6f * ImGui::GetFontSize());
  ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthStretch);
  return true;
}

void property(const char* label) {
  KERF_ASSERT(ImGui::GetCurrentContext()->CurrentTable != nullptr);
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(label);
  ImGui::TableNextColumn();
  ImGui::SetNextItemWidth(-1);
}

void end_properties() {
  KERF_ASSERT(ImGui::GetCurrentContext()->CurrentTable != nullptr);
  ImGui::EndTable();
}

void tooltip(const char* text) {
  if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
  const ImGuiContext& context = *ImGui::GetCurrentContext();
  // Mere text has no id, by which the time over it could be counted.
  if (context.LastItemData.ID == 0) ImGui::ItemHoverable(context.LastItemData.Rect, ImGui::GetID(text));
  if (context.HoveredIdTimer < kTooltipSeconds) return;
  ImGui::PushStyleVar(ImGuiStyleVar_Alpha, 1);  // also over what is disabled
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(22 * ImGui::GetFontSize());
  ImGui::TextUnformatted(text);
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
  ImGui::PopStyleVar();
}

void figure_row(const char* name, const std::string& value, const char* meaning) {
  property(name);
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(value.c_str());
  tooltip(meaning);
}

}  // namespace kerf
