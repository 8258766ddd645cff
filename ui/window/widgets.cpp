#include "ui/window/widgets.h"

#include <GLFW/glfw3.h>
#include <imgui.h>
#include <algorithm>
#include <cfloat>
#include <string>

#include "ui/window/layout.h"
#include "ui/window/property_rows.h"

namespace kerf {

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

namespace {

constexpr float kWidth = 24, kUp = 2;  // em

constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                    ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize |
                                    ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav;

}  // namespace

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
    const char* text = fraction > 0 ? nullptr : "";  // null: the percentage
    ImGui::ProgressBar(static_cast<float>(fraction), {-std::max(beside, FLT_MIN), 0}, text);
    if (can_stop) {
      ImGui::SameLine();
      stopped = ImGui::Button("Cancel");
    }
  }
  ImGui::End();
  return stopped;
}

namespace {

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

}  // namespace

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

namespace {

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
