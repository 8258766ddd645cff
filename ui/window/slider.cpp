#include "ui/window/slider.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "ui/window/fitted_text.h"
#include "ui/window/number_fields.h"
#include "ui/window/number_text.h"
#include "ui/window/property.h"

namespace kerf {

namespace {

constexpr float kGrabPadding = 2;  // that ImGui leaves around the grab

// The text of the slider that is a text field at the moment; ImGui has one at a time, too.
EditedText& edited_slider() {
  static EditedText text;
  return text;
}

struct Value {
  double now, low, high;
  bool whole;
  // Where between the ends it is.
  double share(bool logarithmic) const {
    if (!(high > low)) return 0;
    const double x = std::clamp(now, low, high);
    if (!logarithmic || !(low > 0)) return (x - low) / (high - low);
    return std::log(x / low) / std::log(high / low);
  }
};

// The left and the right end of the grab in the frame of the last item, as SliderBehavior places it.
std::pair<float, float> grab_of(float left, float right, const Value& value, bool logarithmic) {
  const float room = right - left - 2 * kGrabPadding;
  float size = ImGui::GetStyle().GrabMinSize;
  if (value.whole) size = std::max(size, room / static_cast<float>(value.high - value.low + 1));
  size = std::min(size, room);
  const float begin = left + kGrabPadding + (room - size) * static_cast<float>(value.share(logarithmic));
  return {begin, begin + size};
}

// Draws the text beside the grab. Returns whether it had to be shortened.
bool draw_text(const Value& value, bool logarithmic, float width, const std::string& text, bool number,
               const NumberEntry& entry) {
  const ImVec2 at = ImGui::GetItemRectMin();
  const float left = at.x, right = at.x + width, padding = 0.5f * ImGui::GetStyle().FramePadding.x;
  const auto [grab_left, grab_right] = grab_of(left, right, value, logarithmic);
  SliderRoom room = room_beside_grab(left + padding, right - padding, grab_left - padding,
                                     grab_right + padding, width_of_text(text));
  std::string shown = text;
  if (width_of_text(text) > room.width) {
    shown = number ? fitted_number(value.now, entry.format, entry.unit.name, 0, room.width)
                   : fitted_text(text, room.width);
    room = room_beside_grab(left + padding, right - padding, grab_left - padding, grab_right + padding,
                            width_of_text(shown));
  }
  ImGui::GetWindowDrawList()->AddText({room.at, at.y + ImGui::GetStyle().FramePadding.y},
                                      ImGui::GetColorU32(ImGuiCol_Text), shown.c_str());
  return shown != text;
}

// The text field that the slider is at the moment. The number that was entered.
std::optional<double> draw_field(const Slider& slider, const NumberEntry& entry, double value) {
  const std::string shown = entry.shown(value);
  const auto text = edited_slider().draw(slider.id, shown, shown);
  return text ? entry.entered(*text, value) : std::nullopt;
}

// The beginning of the text that is a number, with which ImGui begins the text field.
std::string number_of(const std::string& shown) {
  char* end = nullptr;
  (void)std::strtod(shown.c_str(), &end);
  return shown.substr(0, static_cast<size_t>(end - shown.c_str()));
}

template <typename Number>
bool draw_slider(const Slider& slider, ImGuiDataType type, Number& value, Number low, Number high,
                 const NumberEntry& entry, const NumberFormat& format, const std::string& replaced) {
  const ImGuiID id = ImGui::GetID(slider.id);
  const float width = ImGui::CalcItemWidth();
  bool changed = false;
  std::string text = replaced;
  bool shortened = false;
  if (ImGui::TempInputIsActive(id)) {
    const std::optional<double> typed = draw_field(slider, entry, static_cast<double>(value));
    changed = typed.has_value();
    if (typed && std::is_integral_v<Number>) value = static_cast<Number>(std::round(*typed));
    if (typed && !std::is_integral_v<Number>) value = static_cast<Number>(*typed);
  } else {
    ImGuiSliderFlags flags = ImGuiSliderFlags_AlwaysClamp;
    if (slider.logarithmic) flags |= ImGuiSliderFlags_Logarithmic;
    if (!slider.takes_text) flags |= ImGuiSliderFlags_NoInput;
    ImGui::PushStyleColor(ImGuiCol_Text, 0);  // ImGui would draw it under the grab
    changed = ImGui::SliderScalar(slider.id, type, &value, &low, &high, format.c_str(), flags);
    ImGui::PopStyleColor();
    const std::string shown = entry.shown(static_cast<double>(value));
    if (replaced.empty()) text = shown;
    if (ImGui::TempInputIsActive(id)) {
      edited_slider().begin(number_of(shown));
    } else {
      const Value where{static_cast<double>(value), static_cast<double>(low), static_cast<double>(high),
                        std::is_integral_v<Number>};
      shortened = draw_text(where, slider.logarithmic, width, text, replaced.empty(), entry);
    }
  }
  tooltip(shortened ? (text + '\n' + slider.meaning).c_str() : slider.meaning);
  return changed;
}

}  // namespace

SliderRoom room_beside_grab(float left, float right, float grab_left, float grab_right, float text_width) {
  const float centred = 0.5f * (left + right - text_width);
  const bool on_left = grab_left - left > right - grab_right;
  if (centred + text_width <= grab_left || centred >= grab_right) return {centred, text_width};
  if (on_left) return {std::max(left, grab_left - text_width), grab_left - left};
  return {grab_right, right - grab_right};
}

bool real_slider(const Slider& slider, double& value, double low, double high, const RealFormat& format,
                 const NumberUnit& unit, const std::string& text) {
  const NumberEntry entry{slider.name, format, unit, {low, high}};
  return draw_slider(slider, ImGuiDataType_Double, value, low, high, entry, format, text);
}

bool whole_slider(const Slider& slider, int& value, int low, int high, const std::string& text,
                  const NumberUnit& unit) {
  const NumberRange range{static_cast<double>(low), static_cast<double>(high)};
  const NumberEntry entry{slider.name, RealFormat("%.0f"), unit, range};
  return draw_slider(slider, ImGuiDataType_S32, value, low, high, entry, WholeFormat("%d"), text);
}

}  // namespace kerf
