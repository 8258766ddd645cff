#include "ui/window/number_fields.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

#include "core/base/number_format.h"
#include "ui/window/layout.h"
#include "ui/window/number_text.h"
#include "ui/window/property_rows.h"

namespace kerf {

namespace {

// Global like ImGui's current context.
Message*& entry_message() {
  static Message* message = nullptr;
  return message;
}

float room_in_field() { return ImGui::CalcItemWidth() - 2 * ImGui::GetStyle().FramePadding.x; }

// The tooltip of the last item, with the full text if it is shortened.
void explain(const std::string& shown, const std::string& fitted, const char* meaning) {
  tooltip(fitted == shown ? meaning : (shown + '\n' + meaning).c_str());
}

// The unit for reading, which includes the one in the format.
NumberUnit read_unit(const NumberEntry& entry) {
  NumberUnit unit = entry.unit;
  if (const std::string own = entry.format.unit(); !own.empty()) unit.name = own;
  return unit;
}

}  // namespace

void report_entries_to(Message* message) { entry_message() = message; }

std::string NumberEntry::shown(double value) const { return number_text(value, format, scale) + unit.name; }

std::optional<double> NumberEntry::entered(std::string_view text, double present) const {
  Message* message = entry_message();
  const auto refuse = [&](const std::string& reason) {
    if (message != nullptr) message->error(std::string(name) + " stays " + shown(present) + ": " + reason);
    return std::nullopt;
  };
  const Result<double> value = evaluate_number(text, read_unit(*this));
  if (!value) return refuse(value.error().message);
  if (range.positive && !(*value > 0)) return refuse("it must be more than 0");
  if (range.contains(*value)) return *value;
  const bool low = *value < range.least;
  const double limited = low ? range.least : range.most;
  if (message != nullptr)
    message->info_before_change(std::string(name) + " is limited to " + shown(limited) + ", the " +
                                (low ? "minimum" : "maximum") + " value");
  return limited;
}

std::optional<std::string> EditedText::draw(const char* id, const std::string& shown,
                                            const std::string& fitted) {
  std::array<char, std::tuple_size_v<decltype(typed_)>> text{};
  std::copy_n(shown.begin(), std::min(shown.size(), text.size() - 1), text.begin());
  const bool active = ImGui::GetActiveID() == ImGui::GetID(id);
  const bool shortened = fitted != shown && !active;
  if (shortened) ImGui::PushStyleColor(ImGuiCol_Text, 0);  // only hidden, so that it remains editable
  const bool changed = ImGui::InputText(id, text.data(), text.size(), ImGuiInputTextFlags_AutoSelectAll);
  if (shortened) ImGui::PopStyleColor();
  if (ImGui::IsItemActivated()) begun_ = shown;
  if (changed || active) typed_ = text;  // a text equal to the shown one is not reported as a change
  const bool entered = ImGui::IsItemDeactivatedAfterEdit() && begun_ != typed_.data();
  if (shortened) {
    const ImVec2 at = ImGui::GetItemRectMin(), padding = ImGui::GetStyle().FramePadding;
    ImGui::GetWindowDrawList()->AddText({at.x + padding.x, at.y + padding.y},
                                        ImGui::GetColorU32(ImGuiCol_Text), fitted.c_str());
  }
  return entered ? std::optional<std::string>(typed_.data()) : std::nullopt;
}

bool NumberFields::field(double& value, const NumberEntry& entry, const char* meaning) {
  const std::string shown = entry.shown(value);
  const std::string fitted =
      fitted_number(value, entry.format, entry.unit.name, entry.scale, room_in_field());
  const std::optional<std::string> text = text_.draw("##field", shown, fitted);
  explain(shown, fitted, meaning);
  const std::optional<double> typed = text ? entry.entered(*text, value) : std::nullopt;
  if (typed) value = *typed;
  return typed.has_value();
}

bool NumberFields::count(const char* name, size_t& value, const char* meaning, size_t least, size_t most) {
  property(name);
  const std::string shown = grouped(value);
  const std::string fitted = fitted_text(shown, room_in_field());
  ImGui::PushID(name);
  const std::optional<std::string> text = text_.draw("##field", shown, fitted);
  mark_last_item(name);
  explain(shown, fitted, meaning);
  ImGui::PopID();
  if (!text) return false;
  const NumberRange range{static_cast<double>(least), static_cast<double>(most)};
  const NumberEntry entry{name, RealFormat("%.0f"), {}, range};
  const std::optional<double> typed = entry.entered(*text, static_cast<double>(value));
  if (typed) value = static_cast<size_t>(std::round(*typed));
  return typed.has_value();
}

bool NumberFields::vector(const char* name, Vec3& values, const RealFormat& format, const char* meaning,
                          const NumberUnit& unit, double scale) {
  property(name);
  bool entered = false;
  const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
  const float width = (ImGui::GetContentRegionAvail().x - 2 * gap) / 3;
  const double size = std::max(scale, glm::length(values));
  ImGui::PushID(name);
  for (int i = 0; i < 3; ++i) {
    if (i > 0) ImGui::SameLine(0, gap);
    ImGui::SetNextItemWidth(width);
    ImGui::PushID(i);
    entered = field(values[i], {name, format, unit, kFinite, size}, meaning) || entered;
    mark_last_item(name, i);
    ImGui::PopID();
  }
  ImGui::PopID();
  return entered;
}

bool NumberFields::number(const char* name, double& value, const RealFormat& format, const char* meaning,
                          const NumberUnit& unit, const NumberRange& range) {
  property(name);
  ImGui::PushID(name);
  const bool entered = field(value, {name, format, unit, range}, meaning);
  mark_last_item(name);
  ImGui::PopID();
  return entered;
}

}  // namespace kerf
