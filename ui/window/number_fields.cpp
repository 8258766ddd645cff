#include "ui/window/number_fields.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "core/base/count_text.h"
#include "ui/window/landmarks.h"
#include "ui/window/property.h"

namespace kerf {

std::optional<size_t> count_in(std::string text) {
  constexpr double kMostTyped = 1e15;
  std::erase(text, ' ');
  char* end = nullptr;
  const double number = std::round(std::strtod(text.c_str(), &end));
  if (text.empty() || *end != '\0' || !(number >= 1 && number <= kMostTyped)) return std::nullopt;
  return static_cast<size_t>(number);
}

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

bool NumberFields::count(const char* name, size_t& value, const char* meaning) {
  property(name);
  std::array<char, 32> text{};
  const std::string shown = grouped(value);
  std::copy_n(shown.begin(), std::min(shown.size(), text.size() - 1), text.begin());
  ImGui::PushID(name);
  if (ImGui::InputText("##field", text.data(), text.size())) typed_text_ = text;
  const bool edited = ImGui::IsItemDeactivatedAfterEdit();
  mark_last_item(name);
  tooltip(meaning);
  ImGui::PopID();
  const std::optional<size_t> typed = edited ? count_in(typed_text_.data()) : std::nullopt;
  if (typed) value = *typed;
  return typed.has_value();
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
