#include "ui/window/question.h"

#include <imgui.h>

#include <GLFW/glfw3.h>

#include "ui/window/property.h"

namespace kerf {

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
    if (letter != 0 && key == letter) question.answer = i;  // GLFW's keys of letters are the capitals
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
