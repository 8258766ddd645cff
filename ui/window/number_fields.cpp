#include "ui/window/number_fields.h"

#include <imgui.h>

#include <cmath>

#include "ui/window/landmarks.h"
#include "ui/window/property.h"

namespace kerf {

bool NumberFields::field(double& value, const std::string& format, const char* meaning) {
  double shown = value;
  const bool changed =
      ImGui::InputScalar("##field", ImGuiDataType_Double, &shown, nullptr, nullptr, format.c_str());
  // Without a change the text is the value as it was, which may be typed again.
  if (changed || ImGui::IsItemActive()) typed_ = shown;
  const bool entered = ImGui::IsItemDeactivatedAfterEdit() && std::isfinite(typed_);
  if (entered) value = typed_;
  tooltip(meaning);
  return entered;
}

bool NumberFields::vector(const char* name, Vec3& values, const RealFormat& format, const char* meaning) {
  property(name);
  bool entered = false;
  const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
  const float width = (ImGui::GetContentRegionAvail().x - 2 * gap) / 3;
  ImGui::PushID(name);
  for (int i = 0; i < 3; ++i) {
    if (i > 0) ImGui::SameLine(0, gap);
    ImGui::SetNextItemWidth(width);
    ImGui::PushID(i);
    entered = field(values[i], format.c_str(), meaning) || entered;
    mark_last_item(name, i);
    ImGui::PopID();
  }
  ImGui::PopID();
  return entered;
}

bool NumberFields::number(const char* name, double& value, const RealFormat& format, const char* meaning,
                          std::string_view unit) {
  property(name);
  ImGui::PushID(name);
  const bool entered = field(value, format.with(unit), meaning);
  mark_last_item(name);
  ImGui::PopID();
  return entered;
}

}  // namespace kerf
