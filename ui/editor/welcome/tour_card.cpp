#include "ui/editor/welcome/tour_card.h"

#include <imgui.h>

#include <algorithm>

#include "ui/window/imgui_vector.h"
#include "ui/window/landmarks.h"
#include "ui/window/theme.h"

namespace kerf {

namespace {

constexpr float kWidth = 23, kMargin = 1.2f;  // sizes of the text
constexpr ImGuiWindowFlags kCard = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize |
                                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav;

// A frame around the part, and a line from there to the card.
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
  if (ImGui::Button("End the tour")) move = TourMove::kEnd;
  mark_last_item("tour end");
  ImGui::SameLine();
  ImGui::TextDisabled("%zu of %zu", tour.at() + 1, tour.count());
  return move;
}

}  // namespace

TourMove draw_tour_card(const Tour& tour, const Area& picture, const std::optional<Area>& part) {
  const float em = ImGui::GetFontSize(), margin = kMargin * em;
  // Beside what it points at, which lies right of the picture, else in the upper left corner of the picture,
  // where it hides neither the car nor the hints.
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
