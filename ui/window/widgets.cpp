#include "ui/window/widgets.h"

#include <GLFW/glfw3.h>
#include <imgui_internal.h>
#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "core/base/assert.h"
#include "ui/window/theme.h"

namespace kerf {

namespace {

constexpr const char* kEllipsis = "...";
constexpr int kMaxDigits = 6;

// Returns true if a UTF-8 character begins at this byte.
bool begins_character(char c) { return (static_cast<unsigned char>(c) & 0xc0u) != 0x80u; }

// Shortens "1.2e+05" to "1.2e5".
std::string compact(std::string number) {
  const size_t e = number.find('e');
  if (e == std::string::npos) return number;
  size_t digits = e + 1;
  if (number[digits] == '+') number.erase(digits, 1);
  if (number[digits] == '-') ++digits;
  while (digits + 1 < number.size() && number[digits] == '0') number.erase(digits, 1);
  return number;
}

std::string with_digits(double value, int digits) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.*g", digits, value);
  return compact(text.data());
}

constexpr float kTooltipSeconds = 0.5f;
constexpr float kTooltipEms = 22;  // wrap width
constexpr float kTooltipPaddingEms = 0.6f;

// Places the next tooltip next to the window of the last item, at the height of the item, so that it covers
// neither the content of the window nor the widget; at the pointer if there is no space.
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

// The text of the slider being edited as a text field; ImGui has one at a time, too.
EditedText& edited_slider() {
  static EditedText text;
  return text;
}

// Width of a slider's value field, for short and for long texts.
constexpr float kValueEms = 5, kMaxValueShare = 0.45f, kLongEms = 8, kMaxLongShare = 0.6f;

// Draws the value in a field of this size at `at`. Returns true if it was shortened.
bool draw_value(ImVec2 at, float width, double value, const std::string& text, bool number,
                const NumberEntry& entry) {
  const ImGuiStyle& style = ImGui::GetStyle();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(at, {at.x + width, at.y + ImGui::GetFrameHeight()}, ImGui::GetColorU32(ImGuiCol_FrameBg),
                     style.FrameRounding);
  const float room = width - 2 * style.FramePadding.x;
  const std::string shown =
      number ? fitted_number(value, entry.format, entry.unit.name, 0, room) : fitted_text(text, room);
  list.AddText({at.x + style.FramePadding.x, at.y + style.FramePadding.y}, ImGui::GetColorU32(ImGuiCol_Text),
               shown.c_str());
  return shown != text;
}

// Returns true if the user asks to type: a click on the value field, or a double click on the track.
bool wants_to_type(ImVec2 at, float value_width, float width) {
  if (!ImGui::IsWindowHovered() ||
      (ImGui::GetCurrentContext()->CurrentItemFlags & ImGuiItemFlags_Disabled) != 0)
    return false;
  const float bottom = at.y + ImGui::GetFrameHeight();
  const bool on_value = ImGui::IsMouseHoveringRect(at, {at.x + value_width, bottom});
  if (on_value) ImGui::SetMouseCursor(ImGuiMouseCursor_TextInput);
  return (on_value && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) ||
         (ImGui::IsMouseHoveringRect(at, {at.x + width, bottom}) &&
          ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left));
}

// Draws the slider as a text field. Returns the entered number.
std::optional<double> draw_field(const Slider& slider, const NumberEntry& entry, double value) {
  const std::string shown = entry.shown(value);
  const auto text = edited_slider().draw(slider.id, shown, shown);
  return text ? entry.entered(*text, value) : std::nullopt;
}

// Returns the numeric prefix of the text, the initial content of ImGui's text field.
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
  bool changed = false, shortened = false;
  std::string text = replaced;
  if (ImGui::TempInputIsActive(id) || edited_slider().was_active(id)) {
    ImGui::SetNextItemWidth(width);
    const std::optional<double> typed = draw_field(slider, entry, static_cast<double>(value));
    changed = typed.has_value();
    if (typed && std::is_integral_v<Number>) value = static_cast<Number>(std::round(*typed));
    if (typed && !std::is_integral_v<Number>) value = static_cast<Number>(*typed);
  } else {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const std::string shown = entry.shown(static_cast<double>(value));
    if (replaced.empty()) text = shown;
    const float em = ImGui::GetFontSize(), padding = 2 * ImGui::GetStyle().FramePadding.x;
    float& field = *ImGui::GetStateStorage()->GetFloatRef(id);
    if (ImGui::GetActiveID() != id) {  // the track stays in place while it is dragged
      field = std::min(kValueEms * em, kMaxValueShare * width);
      if (width_of_text(text) + padding > field) field = std::min(kLongEms * em, kMaxLongShare * width);
    }
    const float gap = 0.5f * ImGui::GetStyle().ItemSpacing.x;
    if (slider.takes_text && wants_to_type(at, field, width))
      ImGui::GetCurrentContext()->NavActivateInputId = id;
    ImGui::SetCursorScreenPos({at.x + field + gap, at.y});
    ImGui::SetNextItemWidth(width - field - gap);
    ImGuiSliderFlags flags = ImGuiSliderFlags_AlwaysClamp;
    if (slider.logarithmic) flags |= ImGuiSliderFlags_Logarithmic;
    if (!slider.takes_text) flags |= ImGuiSliderFlags_NoInput;
    ImGui::PushStyleColor(ImGuiCol_Text, 0);  // the value field shows the number
    changed = ImGui::SliderScalar(slider.id, type, &value, &low, &high, format.c_str(), flags);
    ImGui::PopStyleColor();
    if (ImGui::TempInputIsActive(id)) edited_slider().begin(id, number_of(shown));
    if (changed && replaced.empty()) text = entry.shown(static_cast<double>(value));
    shortened = draw_value(at, field, static_cast<double>(value), text, replaced.empty(), entry);
  }
  tooltip(shortened ? (text + '\n' + slider.meaning).c_str() : slider.meaning);
  return changed;
}

constexpr float kWidth = 24, kUp = 2;  // em

constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                    ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize |
                                    ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav;

constexpr ImGuiWindowFlags kStrip = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                    ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoSavedSettings |
                                    ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoNav;

enum class Strip { kUpright, kLevel };

SplitterMove drag_strip(Strip strip, ImVec2 from, ImVec2 size, const char* tip) {
  SplitterMove move;
  ImGui::InvisibleButton("strip", size);
  const bool held = ImGui::IsItemActive(), over = ImGui::IsItemHovered(), upright = strip == Strip::kUpright;
  if (!held) tooltip(tip);
  if (!held && !over) return move;
  ImGui::SetMouseCursor(upright ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_ResizeNS);
  const ImVec2 to = upright ? ImVec2(from.x, from.y + size.y) : ImVec2(from.x + size.x, from.y);
  ImGui::GetForegroundDrawList()->AddLine(
      from, to, ImGui::GetColorU32(held ? ImGuiCol_SeparatorActive : ImGuiCol_SeparatorHovered), 2);
  if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
    move.reset = true;
  } else if (held && ImGui::IsMouseDragging(ImGuiMouseButton_Left, 1)) {
    const ImVec2 pointer = ImGui::GetIO().MousePos;
    move.dragged = upright ? pointer.x : pointer.y;
  }
  return move;
}

SplitterMove draw_strip(Strip strip, const char* id, Vec2 begin, double length, const char* tip) {
  const float half = 0.25f * ImGui::GetFontSize();
  const ImVec2 from = to_im(begin);
  const bool upright = strip == Strip::kUpright;
  const auto along = static_cast<float>(length);
  const ImVec2 size = upright ? ImVec2(2 * half, along) : ImVec2(along, 2 * half);
  ImGui::SetNextWindowPos(upright ? ImVec2(from.x - half, from.y) : ImVec2(from.x, from.y - half));
  ImGui::SetNextWindowSize(size);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1, 1));
  SplitterMove move;
  if (ImGui::Begin(id, nullptr, kStrip)) move = drag_strip(strip, from, size, tip);
  ImGui::End();
  ImGui::PopStyleVar(2);
  return move;
}

constexpr float kWidthEms = 34, kButtonEms = 7;

void draw_choices(Question& question) {
  for (size_t i = 0; i < question.choices.size(); ++i) {
    if (i > 0) ImGui::SameLine();
    const Question::Choice& choice = question.choices[i];
    if (ImGui::Button(choice.label.c_str(), {kButtonEms * ImGui::GetFontSize(), 0})) question.answer = i;
    tooltip(choice.tip.c_str());
  }
}

}  // namespace

float width_of_text(std::string_view text) {
  return ImGui::CalcTextSize(text.data(), text.data() + text.size()).x;
}

std::string fitted_text(std::string_view text, float width, const TextWidth& width_of) {
  if (width_of(text) <= width) return std::string(text);
  const float room = width - width_of(kEllipsis);
  if (room < 0) return "";
  // Finds the longest prefix that fits by bisection; the width increases with the length.
  size_t fits = 0, too_long = text.size();
  while (too_long - fits > 1) {
    size_t middle = (fits + too_long) / 2;
    while (middle > fits && !begins_character(text[middle])) --middle;
    if (middle == fits) {
      middle = (fits + too_long) / 2;
      while (middle < too_long && !begins_character(text[middle])) ++middle;
      if (middle == too_long) break;
    }
    (width_of(text.substr(0, middle)) <= room ? fits : too_long) = middle;
  }
  while (fits > 0 && text[fits - 1] == ' ') --fits;
  return std::string(text.substr(0, fits)) + kEllipsis;
}

std::string fitted_end(std::string_view text, float width, const TextWidth& width_of) {
  if (width_of(text) <= width) return std::string(text);
  for (size_t begin = 1; begin < text.size(); ++begin) {
    if (!begins_character(text[begin])) continue;
    const std::string end = kEllipsis + std::string(text.substr(begin));
    if (width_of(end) <= width) return end;
  }
  return kEllipsis;
}

void fill_field(std::span<char> buffer, std::string_view text) {
  KERF_ASSERT(!buffer.empty());
  size_t length = std::min(text.size(), buffer.size() - 1);
  while (length > 0 && length < text.size() && !begins_character(text[length])) --length;
  std::ranges::fill(buffer, '\0');
  std::copy_n(text.begin(), length, buffer.begin());
}

std::string fitted_number(double value, const RealFormat& format, std::string_view unit, double scale,
                          float width, const TextWidth& width_of) {
  std::string text = number_text(value, format, scale) + std::string(unit);
  if (width_of(text) <= width) return text;
  // The digits as shown, so that the shortened number does not show others.
  char* suffix = nullptr;
  const std::string full = text;
  const double shown = std::strtod(full.c_str(), &suffix);
  if (suffix == full.c_str()) return fitted_text(full, width, width_of);
  for (const std::string& end : {std::string(suffix), std::string()}) {
    for (int digits = kMaxDigits; digits > 0; --digits) {
      text = with_digits(shown, digits) + end;
      if (width_of(text) <= width) return text;
    }
  }
  return kEllipsis;
}

std::string visible_part(const std::string& label) { return label.substr(0, label.find("##")); }

std::string fitted_label(const std::string& label, float width) {
  const std::string seen = visible_part(label), fitted = fitted_text(seen, width);
  if (fitted == seen) return label;
  const size_t id = label.find("###");
  return fitted + "###" + (id == std::string::npos ? label : label.substr(id + 3));
}

bool begin_fitted_combo(const char* id, const std::string& preview) {
  const float room = ImGui::CalcItemWidth() - ImGui::GetFrameHeight() - 2 * ImGui::GetStyle().FramePadding.x;
  return ImGui::BeginCombo(id, whole_label(fitted_text(preview, room)).c_str());
}

// ImGui draws nothing for a carriage return.
std::string whole_label(std::string text) {
  for (size_t at = 0; (at = text.find("##", at)) != std::string::npos; at += 2) text.insert(at + 1, 1, '\r');
  return text.ends_with('#') ? text + '\r' : text;
}

void draw_fitted_text(const std::string& text, const char* meaning, float width) {
  const float room = width > 0 ? width : ImGui::GetContentRegionAvail().x;
  const std::string fitted = fitted_text(text, room);
  ImGui::TextUnformatted(fitted.c_str());
  if (fitted != text) {
    tooltip(meaning != nullptr ? (text + '\n' + meaning).c_str() : text.c_str());
  } else if (meaning != nullptr) {
    tooltip(meaning);
  }
}

bool begin_properties(const char* id) {
  if (!ImGui::BeginTable(id, 2, ImGuiTableFlags_SizingStretchProp)) return false;
  ImGui::TableSetupColumn("label", ImGuiTableColumnFlags_WidthFixed, 5.6f * ImGui::GetFontSize());
  // Without a weight the column would have no width in its first frame.
  ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthStretch, 1);
  return true;
}

void property(const char* label) {
  if (ImGui::GetCurrentContext()->CurrentTable == nullptr) {
    ImGui::AlignTextToFramePadding();
    ImGui::PushStyleColor(ImGuiCol_Text, colours::secondary());
    ImGui::TextUnformatted(label);
    ImGui::PopStyleColor();
    return ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
  }
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
  // Plain text has no ID to time the hovering with.
  if (context.LastItemData.ID == 0) ImGui::ItemHoverable(context.LastItemData.Rect, ImGui::GetID(text));
  if (context.HoveredIdTimer < kTooltipSeconds || ImGui::IsAnyMouseDown()) return;
  ImGui::PushStyleVar(ImGuiStyleVar_Alpha, 1);  // opaque even for disabled items
  // The window of the item may have no padding.
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {kTooltipPaddingEms * ImGui::GetFontSize(),
                                                    0.7f * kTooltipPaddingEms * ImGui::GetFontSize()});
  place_tooltip(text, picture);
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(kTooltipEms * ImGui::GetFontSize());
  ImGui::TextUnformatted(text);
  ImGui::PopTextWrapPos();
  if (picture) ImGui::Image(to_im_texture(picture->texture), to_im(picture->size));
  ImGui::EndTooltip();
  ImGui::PopStyleVar(2);
}

void figure_row(const char* name, const std::string& value, const char* meaning) {
  property(name);
  ImGui::AlignTextToFramePadding();
  draw_fitted_text(value, meaning);
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

bool row_button(const char* label, int shares, const char* disabled_reason, const char* meaning) {
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  const float room = ImGui::GetWindowContentRegionMax().x - ImGui::GetWindowContentRegionMin().x;
  ImGui::BeginDisabled(disabled_reason != nullptr);
  const float width = (room - gap * static_cast<float>(shares - 1)) / static_cast<float>(shares);
  const std::string fitted = fitted_label(label, width - ImGui::GetStyle().FramePadding.x);
  const bool pressed = ImGui::Button(fitted.c_str(), {width, 0});
  ImGui::EndDisabled();
  mark_last_item(label);
  const std::string text = disabled_reason != nullptr ? disabled_reason : meaning;
  tooltip((fitted == label ? text : visible_part(label) + ". " + text).c_str());
  return pressed;
}

bool unit_combo(FileUnit& unit) {
  int selected = static_cast<int>(unit);
  const bool changed = ImGui::Combo("##unit", &selected, "mm\0cm\0m\0in\0");
  mark_last_item("unit");
  tooltip("Length of one file unit. It changes displayed lengths, never positions.");
  if (changed) unit = static_cast<FileUnit>(selected);
  return changed;
}

bool up_axis_combo(UpAxis& up) {
  int selected = static_cast<int>(up);
  const bool changed = ImGui::Combo("##up", &selected, "+Y\0+Z\0");
  mark_last_item("up axis");
  tooltip("Up axis of the file. It turns the view, never positions.");
  if (changed) up = static_cast<UpAxis>(selected);
  return changed;
}

std::string progress_text(double fraction) {
  return fraction > 0 ? text_of("%.0f %%", std::floor(std::min(99.0, 100 * fraction))) : "";
}

bool draw_progress(const Area& picture, const std::string& title, double fraction, bool can_stop) {
  const float em = ImGui::GetFontSize();
  bool stopped = false;
  ImGui::SetNextWindowPos({static_cast<float>(picture.at.x + picture.size.x / 2),
                           static_cast<float>(picture.at.y + picture.size.y) - kUp * em},
                          ImGuiCond_Always, {0.5f, 1});
  ImGui::SetNextWindowSize({kWidth * em, 0});
  if (ImGui::Begin("##progress", nullptr, kFixed)) {
    ImGui::TextUnformatted(title.c_str());
    const float button = ImGui::CalcTextSize("Cancel").x + 2 * ImGui::GetStyle().FramePadding.x;
    const float beside = can_stop ? button + ImGui::GetStyle().ItemSpacing.x : 0;
    const std::string text = progress_text(fraction);
    ImGui::ProgressBar(static_cast<float>(fraction), {-std::max(beside, FLT_MIN), 0}, text.c_str());
    if (can_stop) {
      ImGui::SameLine();
      stopped = ImGui::Button("Cancel");
    }
  }
  ImGui::End();
  return stopped;
}

SplitterMove splitter(const char* id, Vec2 top, double height, const char* tip) {
  return draw_strip(Strip::kUpright, id, top, height, tip);
}

SplitterMove splitter_across(const char* id, Vec2 left, double width, const char* tip) {
  return draw_strip(Strip::kLevel, id, left, width, tip);
}

bool begin_centred_window(const char* title, const char* landmark, bool& shown, float width_ems,
                          float height_ems) {
  constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoMove |
                                      ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoSavedSettings;
  const float em = ImGui::GetFontSize();
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({0.5f * window.x, 0.5f * window.y}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSize(
      {std::min(window.x - 2 * em, width_ems * em), std::min(window.y - 4 * em, height_ems * em)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 3);
  const bool visible = ImGui::Begin(title, &shown, kFixed);
  if (visible) mark_window(landmark);
  return visible;
}

void end_centred_window() {
  ImGui::End();
  ImGui::PopStyleVar(2);
}

void question_key(Question& question, int key) {
  if (question.choices.empty()) return;
  if (key == GLFW_KEY_ENTER || key == GLFW_KEY_KP_ENTER) question.answer = 0;
  if (key == GLFW_KEY_ESCAPE) question.answer = question.choices.size() - 1;
  for (size_t i = 0; i < question.choices.size(); ++i) {
    const char letter = question.choices[i].letter;
    if (letter != 0 && key == letter) question.answer = i;  // GLFW's letter keys are capitals
  }
}

void draw_question(Question& question) {
  if (!question.open()) return;
  const std::string name = question.title + "###question";
  if (!ImGui::IsPopupOpen(name.c_str())) ImGui::OpenPopup(name.c_str());
  const float em = ImGui::GetFontSize();
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  const float width = std::min(kWidthEms * em, 0.92f * window.x);
  ImGui::SetNextWindowSize({width, 0});
  ImGui::SetNextWindowPos({0.5f * window.x, 0.4f * window.y}, ImGuiCond_Always, {0.5f, 0.5f});
  constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                                      ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
  const bool drawn = ImGui::BeginPopupModal(name.c_str(), nullptr, kFixed);
  ImGui::PopStyleVar();
  if (!drawn) return;
  ImGui::PushTextWrapPos(0);
  ImGui::Spacing();
  ImGui::TextUnformatted(question.text.c_str());
  ImGui::PopTextWrapPos();
  ImGui::Spacing();
  ImGui::Spacing();
  draw_choices(question);
  if (question.answer) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
}

}  // namespace kerf
