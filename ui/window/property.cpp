#include "ui/window/property.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>

#include "core/base/assert.h"
#include "ui/window/fitted_text.h"
#include "ui/window/imgui_vector.h"

namespace kerf {

namespace {

constexpr float kTooltipSeconds = 0.5f;
constexpr float kTooltipEms = 22;  // at which its lines are wrapped

// Places the next tooltip beside the window of the last item, at the height of the item, so that it covers
// neither what the user reads there nor the widget; a window that leaves no room beside it gets the tooltip
// at the pointer.
void place_tooltip(const char* text, const std::optional<TipPicture>& picture) {
  const ImGuiWindow& innermost = *ImGui::GetCurrentWindow();
  const bool in_submenu = (innermost.Flags & ImGuiWindowFlags_ChildMenu) != 0;
  const ImGuiWindow& window = in_submenu ? innermost : *innermost.RootWindow;
  const ImGuiStyle& style = ImGui::GetStyle();
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  const ImVec2 lines = ImGui::CalcTextSize(text, nullptr, false, kTooltipEms * ImGui::GetFontSize());
  ImVec2 size(lines.x + 2 * style.WindowPadding.x, lines.y + 2 * style.WindowPadding.y);
  if (picture) {
    size.x = std::max(size.x, static_cast<float>(picture->size.x) + 2 * style.WindowPadding.x);
    size.y += static_cast<float>(picture->size.y) + style.ItemSpacing.y;
  }
  const float gap = style.ItemSpacing.x;
  const float left = window.Pos.x, right = left + window.Size.x;
  const bool fits_left = left >= size.x + gap, fits_right = right + gap + size.x <= display.x;
  if (!fits_left && !fits_right) return;
  const float x = fits_left ? left - gap - size.x : right + gap;
  const float y = std::min(ImGui::GetItemRectMin().y, display.y - size.y);
  ImGui::SetNextWindowPos({x, std::max(y, 0.0f)});
}

}  // namespace

bool begin_properties(const char* id) {
  if (!ImGui::BeginTable(id, 2, ImGuiTableFlags_SizingStretchProp)) return false;
  ImGui::TableSetupColumn("label", ImGuiTableColumnFlags_WidthFixed, 5.6f * ImGui::GetFontSize());
  // Without a weight the column would be as wide as nothing in its first frame.
  ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthStretch, 1);
  return true;
}

void property(const char* label) {
  KERF_ASSERT(ImGui::GetCurrentContext()->CurrentTable != nullptr);
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::AlignTextToFramePadding();
  draw_fitted_text(label);
  ImGui::TableNextColumn();
  ImGui::SetNextItemWidth(-1);
}

void end_properties() {
  KERF_ASSERT(ImGui::GetCurrentContext()->CurrentTable != nullptr);
  ImGui::EndTable();
}

void tooltip(const char* text, const std::optional<TipPicture>& picture) {
  if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
  const ImGuiContext& context = *ImGui::GetCurrentContext();
  // Mere text has no id, by which the time over it could be counted.
  if (context.LastItemData.ID == 0) ImGui::ItemHoverable(context.LastItemData.Rect, ImGui::GetID(text));
  if (context.HoveredIdTimer < kTooltipSeconds || ImGui::IsAnyMouseDown()) return;
  ImGui::PushStyleVar(ImGuiStyleVar_Alpha, 1);  // also over what is disabled
  place_tooltip(text, picture);
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(kTooltipEms * ImGui::GetFontSize());
  ImGui::TextUnformatted(text);
  ImGui::PopTextWrapPos();
  if (picture) ImGui::Image(to_im_texture(picture->texture), to_im(picture->size));
  ImGui::EndTooltip();
  ImGui::PopStyleVar();
}

void figure_row(const char* name, const std::string& value, const char* meaning) {
  property(name);
  ImGui::AlignTextToFramePadding();
  draw_fitted_text(value, meaning);
}

}  // namespace kerf
