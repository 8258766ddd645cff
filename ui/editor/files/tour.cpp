#include "ui/editor/files/tour.h"

#include <imgui.h>
#include <algorithm>

#include "core/base/assert.h"
#include "ui/editor/shared/panel_rows.h"
#include "ui/window/layout.h"
#include "ui/window/theme.h"
#include "ui/window/widgets.h"

namespace kerf {

namespace {

constexpr Ticks kSeenFalling = kTicksPerSecond;

// Returns "Ctrl+Z undoes the stroke."; the name of the action if no key is bound to it.
std::string by_key(const ViewState& view, const char* id, const std::string& name, const std::string& rest) {
  const std::string key = shortcut_of(view, id);
  return (key.empty() ? "\"" + name + "\"" : key) + rest;
}

}  // namespace

TourMoment tour_moment(const Workspace& workspace) {
  const Document& document = workspace.session.document;
  const ShowOptions& show = workspace.view.look.show;
  return {.position = document.history().position(),
          .cuts = workspace.cutting(),
          .eye = workspace.view.seen_first().eye,
          .clock = document.world().clock(),
          .plays = workspace.links.plays,
          .shows_edges = show.wire,
          .shows_boxes = show.aabb || show.aabb_hit,
          .edge = workspace.laser.resolution.edge_fraction * workspace.laser.radius,
          .saved = !workspace.session.file.empty() &&
                   workspace.session.saved_commands == document.journal().size()};
}

std::vector<TourStep> first_five_minutes(const ViewState& view) {
  using M = TourMoment;
  return {
      {"Cut",
       "JointMode the left button to the left of the windscreen, drag through the windows past the back of "
       "the "
       "car, "
       "and release.",
       "", [](const M& begin, const M& now) { return now.position > begin.position && !now.cuts; }},
      {"Undo", by_key(view, "edit.undo", "Undo", " undoes the stroke: the car is whole again."),
       "panel history", [](const M& begin, const M& now) { return now.position < begin.position; }},
      {"Redo", by_key(view, "edit.redo", "Redo", " cuts it again. The History panel goes to any step."),
       "panel history", [](const M& begin, const M& now) { return now.position > begin.position; }},
      {"Orbit", "Drag with the middle button, or with Alt and the left one, to orbit; scroll to zoom.", "",
       [](const M& begin, const M& now) { return now.eye != begin.eye; }},
      {"Let it fall",
       by_key(view, "physics.play", "Play",
              " lets time pass: what is cut off falls. The Physics tab sets how fast."),
       "tab physics",
       [](const M& begin, const M& now) { return now.plays && now.clock >= begin.clock + kSeenFalling; }},
      {"Stop time",
       by_key(view, "physics.play", "Play", " again stops it; ") +
           by_key(view, "edit.undo", "Undo", " puts all back."),
       "", [](const M&, const M& now) { return !now.plays; }},
      {"See the faces",
       by_key(view, "view.wire", "Wireframe",
              " shows the edges: Kerf refines where the beam bites, and nowhere else."),
       "tab view", [](const M& begin, const M& now) { return now.shows_edges != begin.shows_edges; }},
      {"Refine", "Drag the slider Edge in the Resolution panel: the last stroke is cut again while it moves.",
       "resolution size", [](const M& begin, const M& now) { return now.edge != begin.edge; }},
      {"Look into the tree",
       by_key(view, "view.boxes", "AABB Tree",
              " shows the boxes of the AABB tree that finds the faces: red where the beam was."),
       "tab view", [](const M& begin, const M& now) { return now.shows_boxes != begin.shows_boxes; }},
      {"Keep it",
       by_key(view, "file.save", "Save",
              " writes all of it, with everything that can be undone. This was the tour; Help has it "
              "and all keys."),
       "", [](const M& begin, const M& now) { return now.saved && !begin.saved; }},
  };
}

void Tour::begin(std::vector<TourStep> steps, const TourMoment& now) {
  KERF_ASSERT(!steps.empty());
  steps_ = std::move(steps);
  go_to(0, now);
}

void Tour::follow(const TourMoment& now) {
  if (is_on() && step().done(begin_, now)) skip(now);
}

void Tour::skip(const TourMoment& now) {
  KERF_ASSERT(is_on());
  if (at_ + 1 == steps_.size()) return end();
  go_to(at_ + 1, now);
}

void Tour::go_back(const TourMoment& now) {
  KERF_ASSERT(is_on());
  if (at_ > 0) go_to(at_ - 1, now);
}

const TourStep& Tour::step() const {
  KERF_ASSERT(is_on());
  return steps_[at_];
}

void Tour::go_to(size_t step, const TourMoment& now) {
  at_ = step;
  begin_ = now;
}

namespace {

constexpr float kWidth = 23, kMargin = 1.2f;  // sizes of the text
constexpr ImGuiWindowFlags kCard = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize |
                                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav;

// Draws a frame around the part, and a line from there to the card.
void point_at(const Area& part, ImVec2 card_corner) {
  ImDrawList& list = *ImGui::GetForegroundDrawList();
  const float gap = 0.2f * ImGui::GetFontSize();
  const ImVec2 low = to_im(part.at - Vec2(gap)), high = to_im(part.at + part.size + Vec2(gap));
  list.AddRect(low, high, colours::accent(), 3, 0, 2);
  const float y = std::clamp(card_corner.y, low.y, high.y);
  list.AddLine({low.x, y}, card_corner, colours::accent(), 2);
}

TourMove draw_buttons(const Tour& tour) {
  TourMove move = TourMove::kNone;
  ImGui::BeginDisabled(tour.at() == 0);
  if (ImGui::Button("Back")) move = TourMove::kBack;
  ImGui::EndDisabled();
  ImGui::SameLine();
  if (ImGui::Button(tour.at() + 1 == tour.count() ? "Done" : "Next")) move = TourMove::kOn;
  mark_last_item("tour next");
  ImGui::SameLine();
  if (ImGui::Button("End Tour")) move = TourMove::kEnd;
  mark_last_item("tour end");
  ImGui::SameLine();
  ImGui::TextDisabled("%zu of %zu", tour.at() + 1, tour.count());
  return move;
}

}  // namespace

TourMove draw_tour_card(const Tour& tour, const Area& picture, const std::optional<Area>& part) {
  const float em = ImGui::GetFontSize(), margin = kMargin * em;
  // Next to what it points at, which is right of the viewport, else in the upper left corner of the
  // viewport, where it hides neither the car nor the hints.
  const auto left = static_cast<float>(picture.at.x) + margin;
  const auto right = static_cast<float>(picture.at.x + picture.size.x) - margin;
  const float top =
      part ? static_cast<float>(part->at.y) + margin : static_cast<float>(picture.at.y) + 4 * em;
  const auto lowest = static_cast<float>(picture.at.y + picture.size.y) - 9 * em;
  const ImVec2 corner(part ? right : left, std::min(top, lowest));
  ImGui::SetNextWindowPos(corner, ImGuiCond_Always, {part ? 1.0f : 0.0f, 0});
  ImGui::SetNextWindowSize({std::min(kWidth * em, static_cast<float>(picture.size.x) - 2 * margin), 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 3);
  TourMove move = TourMove::kNone;
  if (ImGui::Begin("##tour", nullptr, kCard)) {
    mark_window("tour");
    ImGui::PushStyleColor(ImGuiCol_Text, colours::accent());
    ImGui::TextUnformatted(tour.step().title.c_str());
    ImGui::PopStyleColor();
    ImGui::TextWrapped("%s", tour.step().text.c_str());
    ImGui::Spacing();
    move = draw_buttons(tour);
  }
  ImGui::End();
  ImGui::PopStyleVar();
  if (part) point_at(*part, {corner.x, corner.y + 0.5f * em});
  return move;
}

}  // namespace kerf
