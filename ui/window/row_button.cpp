#include "ui/window/row_button.h"

#include <imgui.h>

#include "ui/window/landmarks.h"
#include "ui/window/property.h"

namespace kerf {

bool row_button(const char* label, int shares, const char* why_not, const char* meaning) {
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  const float room = ImGui::GetWindowContentRegionMax().x - ImGui::GetWindowContentRegionMin().x;
  ImGui::BeginDisabled(why_not != nullptr);
  const bool pressed =
      ImGui::Button(label, {(room - gap * static_cast<float>(shares - 1)) / static_cast<float>(shares), 0});
  ImGui::EndDisabled();
  mark_last_item(label);
  tooltip(why_not != nullptr ? why_not : meaning);
  return pressed;
}

}  // namespace kerf
