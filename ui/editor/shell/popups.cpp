#include "ui/editor/shell/popups.h"

#include <imgui.h>
#include <imgui_internal.h>

#include "core/base/assert.h"

namespace kerf {

bool is_popup_open() {
  constexpr ImGuiPopupFlags kAny = ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel;
  return ImGui::IsPopupOpen(nullptr, kAny) && ImGui::GetTopMostPopupModal() == nullptr;
}

void close_popups() {
  KERF_ASSERT(ImGui::GetCurrentContext()->WithinFrameScope);
  ImGui::ClosePopupToLevel(0, true);
}

bool pointer_is_over_panel() {
  KERF_ASSERT(ImGui::GetCurrentContext()->WithinFrameScope);
  return ImGui::IsWindowHovered(ImGuiHoveredFlags_AnyWindow | ImGuiHoveredFlags_AllowWhenBlockedByPopup |
                                ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
}

}  // namespace kerf
