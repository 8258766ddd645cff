#include "ui/window/row_button.h"

#include <imgui.h>

#include <string>

#include "ui/window/fitted_text.h"
#include "ui/window/landmarks.h"
#include "ui/window/property.h"

namespace kerf {

bool row_button(const char* label, int shares, const char* why_not, const char* meaning) {
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  const float room = ImGui::GetWindowContentRegionMax().x - ImGui::GetWindowContentRegionMin().x;
  ImGui::BeginDisabled(why_not != nullptr);
  const float width = (room - gap * static_cast<float>(shares - 1)) / static_cast<float>(shares);
  const std::string fitted = fitted_label(label, width - ImGui::GetStyle().FramePadding.x);
  const bool pressed = ImGui::Button(fitted.c_str(), {width, 0});
  ImGui::EndDisabled();
  mark_last_item(label);
  const std::string text = why_not != nullptr ? why_not : meaning;
  tooltip((fitted == label ? text : visible_part(label) + ". " + text).c_str());
  return pressed;
}

}  // namespace kerf
