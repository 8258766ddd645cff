#include "ui/editor/single_step/single_step_panel.h"

#include <imgui.h>

#include <algorithm>

#include "ui/editor/shared/panels/panel_rows.h"
#include "ui/editor/shared/panels/shortcut_text.h"
#include "ui/window/fitted_text.h"
#include "ui/window/landmarks.h"
#include "ui/window/number_text.h"
#include "ui/window/property.h"
#include "ui/window/slider.h"
#include "ui/window/theme.h"

namespace kerf {

namespace {

constexpr float kRows = 9;

// A button that tells the key of an action, or says why it cannot be pressed at the moment. Returns whether
// it was pressed.
bool button(const ViewState& view, const char* label, const char* mark, const char* tip, const char* action,
            const char* why_not, float width) {
  ImGui::BeginDisabled(why_not != nullptr);
  const std::string fitted = fitted_label(label, width - ImGui::GetStyle().FramePadding.x);
  const bool pressed = ImGui::Button(fitted.c_str(), {width, 0});
  ImGui::EndDisabled();
  mark_last_item(mark);
  const std::string text = why_not != nullptr ? why_not : with_shortcut(view, tip, action);
  tooltip((fitted == label ? text : visible_part(label) + ". " + text).c_str());
  return pressed;
}

// That of one of so many buttons in a row.
float width_of_one(int buttons) {
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  return (ImGui::GetContentRegionAvail().x - static_cast<float>(buttons - 1) * gap) /
         static_cast<float>(buttons);
}

void draw_beginnings(StageState& stages, const Document& document, const ViewState& view) {
  StageWishes& wishes = stages.wishes;
  bool on = wishes.on;
  if (ImGui::Checkbox((with_shortcut(view, "Single steps", "Single steps") + "###on").c_str(), &on)) {
    wishes.stop();
    wishes.on = on;
  }
  mark_last_item("stages on");
  tooltip("A stroke waits when it is drawn, and is cut stage by stage. The result is the same.");
  ImGui::SameLine();
  if (button(view, "Start again", "stage start",
             "Takes the last stroke back, to be cut again stage by stage.", "Step through the last stroke",
             why_not_again(document), width_of_one(1)))
    wishes.begin_again();
}

void draw_steps(StageState& stages, const Document& document, const ViewState& view) {
  StageWishes& wishes = stages.wishes;
  const char* no_next = why_no_next_stage(stages, document);
  const float third = width_of_one(3);
  if (button(view, "Back", "stage back", "Takes the last stage back.", "Stage back",
             why_no_stage_back(stages, document), third))
    wishes.go_to(stages.log.done() - 1);
  ImGui::SameLine();
  const char* no_play = no_next != nullptr && !wishes.playing ? why_not_again(document) : nullptr;
  if (button(view, wishes.playing ? "Pause" : "Play", "stage play",
             "Executes stage after stage. At the end of the stroke it begins again.", "Play the stages",
             no_play, third))
    play_or_pause(stages, document);
  ImGui::SameLine();
  if (button(view, "Next", "stage next", "Executes one stage.", "Next stage", no_next, third))
    wishes.go_to(stages.log.done() + 1);
  const float half = width_of_one(2);
  if (button(view, "Finish the move", "stage end of move",
             "Executes stages until a move of the beam is finished.", "Finish the move", no_next, half))
    wishes.run_to_end_of_move();
  ImGui::SameLine();
  if (button(view, "Finish the stroke", "stage end of stroke", "Executes all stages that are left.",
             "Finish the stroke", no_next, half))
    wishes.go_to(StageWishes::kAll);
}

void draw_speed(StageWishes& wishes) {
  if (!begin_properties("speed")) return;
  property("Speed");
  real_slider({"Speed", "##speed", "How many stages a second are played.", true}, wishes.per_second,
              StageWishes::kSlowest, StageWishes::kFastest, "%.1f stages/s");
  mark_last_item("stage speed");
  end_properties();
}

// Returns whether the row was clicked.
bool draw_row(size_t stage, const std::string& sentence, size_t done) {
  ImGui::PushID(static_cast<int>(stage));
  const bool now = stage == done, ahead = stage > done;
  if (now) ImGui::PushStyleColor(ImGuiCol_Text, colours::accent());
  if (ahead) ImGui::PushStyleColor(ImGuiCol_Text, colours::secondary());
  const std::string text = std::to_string(stage) + "  " + sentence;
  const bool clicked = ImGui::Selectable(fitted_text(text, ImGui::GetContentRegionAvail().x).c_str(), now);
  mark_last_item("stage row", static_cast<int>(stage));
  if (now || ahead) ImGui::PopStyleColor();
  tooltip((sentence + (ahead ? " A click executes the stages up to this one."
                       : now ? ""
                             : " A click goes back to this stage."))
              .c_str());
  ImGui::PopID();
  return clicked && !now;
}

std::string place_text(const StageState& stages, const Document& document) {
  const size_t done = stages.log.done(), known = stages.log.told().size();
  const std::string of = document.waiting() == 0 ? grouped(done)
                         : known > done          ? "at least " + grouped(known)
                                                 : "";
  if (done == 0) return document.waiting() > 0 ? "Before the first stage of the stroke" : "";
  return "Move " + grouped(stages.log.moves()) + " of the beam, stage " +
         grouped(stages.log.stage_of_move()) + " of it; " + grouped(done) + (of.empty() ? "" : " of " + of) +
         " in all";
}

}  // namespace

void SingleStepPanel::draw_list(StageState& stages, const Document& document) {
  const std::vector<std::string>& told = stages.log.told();
  const size_t done = stages.log.done();
  const float line = ImGui::GetTextLineHeightWithSpacing();
  const float height = std::min(kRows, static_cast<float>(told.size())) * line + 0.5f * line;
  ImGui::PushStyleColor(ImGuiCol_ChildBg, ImGui::GetColorU32(ImGuiCol_FrameBg));
  if (ImGui::BeginChild("##stages", {0, height}, true)) {
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(told.size()), line);
    while (clipper.Step()) {
      for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
        const auto stage = static_cast<size_t>(i) + 1;
        const bool clicked = draw_row(stage, told[stage - 1], done);
        if (clicked && (stage > done || why_not_again(document) == nullptr)) stages.wishes.go_to(stage);
      }
    }
    if (shown_ != done) ImGui::SetScrollY(line * static_cast<float>(done) - 0.6f * height);
    shown_ = done;
  }
  ImGui::EndChild();
  ImGui::PopStyleColor();
}

void SingleStepPanel::draw(StageState& stages, const Document& document, const ViewState& view) {
  draw_beginnings(stages, document, view);
  if (!stages.wishes.on) return;
  draw_steps(stages, document, view);
  draw_speed(stages.wishes);
  const std::string place = place_text(stages, document);
  if (place.empty()) {
    return secondary_text("Draw a stroke, or start the last one again.");
  }
  ImGui::TextWrapped("%s", place.c_str());
  if (!stages.log.told().empty()) draw_list(stages, document);
  if (stages.log.done() > 0) ImGui::TextWrapped("%s", stages.log.told()[stages.log.done() - 1].c_str());
  mark_last_item("stage words");
}

}  // namespace kerf
