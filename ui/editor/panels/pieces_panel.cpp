#include "ui/editor/panels/pieces_panel.h"

#include <imgui.h>

#include "ui/editor/view/piece_set.h"
#include "ui/window/number_text.h"
#include "ui/window/property.h"
#include "ui/window/theme.h"

namespace kerf {

namespace {

constexpr size_t kMostRows = 8;  // that are seen at once
constexpr double kMostSpread = 1.5;

void draw_swatch(uint32_t number, bool strong) {
  const Vec3 c = piece_colour(number, strong);
  const float side = 0.8f * ImGui::GetFontSize();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float y = at.y + 0.5f * (ImGui::GetTextLineHeight() - side);
  const ImU32 colour = ImGui::ColorConvertFloat4ToU32(
      {static_cast<float>(c.x), static_cast<float>(c.y), static_cast<float>(c.z), 1});
  ImGui::GetWindowDrawList()->AddRectFilled({at.x, y}, {at.x + side, y + side}, colour, 2);
  ImGui::Dummy({side, ImGui::GetTextLineHeight()});
}

void eye_button(Requests& requests, const PieceRow& row, bool hidden) {
  ImGui::PushStyleColor(ImGuiCol_Text, hidden ? colours::secondary() : colours::text());
  ImGui::PushStyleColor(ImGuiCol_Button, IM_COL32(0, 0, 0, 0));
  ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, 0);
  const bool pressed = ImGui::SmallButton(hidden ? "show" : "hide");
  ImGui::PopStyleVar();
  ImGui::PopStyleColor(2);
  tooltip(hidden ? "Draws this piece again."
                 : "Leaves this piece out of the picture; the beam passes it by.");
  if (!pressed) return;
  requests.commands.emplace_back(HidePiece{row.id, !hidden});
}

void draw_row(ViewState& view, Requests& requests, const PieceRow& row) {
  const auto found = view.look.pieces.find(row.id);
  const PieceLook look = found != view.look.pieces.end() ? found->second : PieceLook();
  ImGui::PushID(static_cast<int>(row.id.body.slot));
  ImGui::PushID(static_cast<int>(row.id.label));
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  draw_swatch(row.number, view.look.show.pieces);
  ImGui::SameLine();
  if (look.selected) ImGui::PushStyleColor(ImGuiCol_Text, colours::accent());
  if (look.hidden) ImGui::PushStyleColor(ImGuiCol_Text, colours::secondary());
  const float room = ImGui::GetContentRegionAvail().x;
  const bool clicked =
      ImGui::Selectable(row.name.c_str(), look.selected, ImGuiSelectableFlags_None, {room, 0});
  if (look.hidden) ImGui::PopStyleColor();
  if (look.selected) ImGui::PopStyleColor();
  tooltip((row.name + ". Click chooses it, Ctrl+click or Shift+click adds it.").c_str());
  if (clicked && !look.hidden) {
    const ImGuiIO& io = ImGui::GetIO();
    choose_piece(view.look.pieces, row.id, io.KeyCtrl || io.KeyShift);
    view.picture_old = true;
  }
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(grouped(row.faces).c_str());
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(area_text(row.area).c_str());
  ImGui::TableNextColumn();
  eye_button(requests, row, look.hidden);
  ImGui::PopID();
  ImGui::PopID();
}

void draw_list(ViewState& view, Requests& requests, const std::vector<PieceRow>& rows) {
  constexpr ImGuiTableFlags kList =
      ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg | ImGuiTableFlags_NoPadOuterX;
  const float em = ImGui::GetFontSize();
  const auto lines = static_cast<float>(std::min(rows.size(), kMostRows) + 1);
  const float height = lines * (ImGui::GetTextLineHeight() + 2 * ImGui::GetStyle().CellPadding.y) + 0.2f * em;
  if (!ImGui::BeginTable("pieces", 4, kList, {0, height})) return;
  ImGui::TableSetupScrollFreeze(0, 1);
  ImGui::TableSetupColumn("Piece", ImGuiTableColumnFlags_WidthStretch);
  ImGui::TableSetupColumn("Faces", ImGuiTableColumnFlags_WidthFixed, 3.7f * em);
  ImGui::TableSetupColumn("Area", ImGuiTableColumnFlags_WidthFixed, 4.4f * em);
  const float button = ImGui::CalcTextSize("show").x + 2 * ImGui::GetStyle().FramePadding.x;
  ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, button);
  ImGui::TableHeadersRow();
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(rows.size()));
  while (clipper.Step()) {
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i)
      draw_row(view, requests, rows[static_cast<size_t>(i)]);
  }
  ImGui::EndTable();
}

// A button that takes its share of the row, and says why when it can do nothing.
bool row_button(const char* label, int shares, bool can, const char* meaning, const char* why_not) {
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  const float room = ImGui::GetWindowContentRegionMax().x - ImGui::GetWindowContentRegionMin().x;
  ImGui::BeginDisabled(!can);
  const bool pressed =
      ImGui::Button(label, {(room - gap * static_cast<float>(shares - 1)) / static_cast<float>(shares), 0});
  ImGui::EndDisabled();
  tooltip(can ? meaning : why_not);
  return pressed;
}

void draw_buttons(const PieceMap& looks, Requests& requests, const std::function<void()>& browse_export) {
  const size_t chosen = chosen_pieces(looks), hidden = hidden_pieces(looks).size();
  constexpr const char* kNoneChosen =
      "No piece is chosen: Ctrl+click one in the picture, or click it in the list.";
  if (row_button("Hide", 3, chosen > 0, "Leaves the chosen pieces out of the picture (H).", kNoneChosen)) {
    requests.hide_chosen = true;
  }
  ImGui::SameLine();
  if (row_button("Show all", 3, hidden > 0, "Draws the hidden pieces again (Shift+H).",
                 "No piece is hidden.")) {
    requests.show_hidden = true;
  }
  ImGui::SameLine();
  if (row_button("Export", 3, chosen > 0, "Writes the chosen pieces to mesh files (Ctrl+E).", kNoneChosen)) {
    browse_export();
  }
}

void draw_spread(const World& world, ViewState& view, bool one_piece) {
  if (!begin_properties("spread")) return;
  property("Spread");
  constexpr double kNone = 0;
  ImGui::BeginDisabled(one_piece);
  const std::string format = view.spread == 0 ? "together" : "%.2f";
  if (ImGui::SliderScalar("##spread", ImGuiDataType_Double, &view.spread, &kNone, &kMostSpread,
                          format.c_str(), ImGuiSliderFlags_AlwaysClamp)) {
    spread_pieces(world, view.spread, view.look.pieces);
    view.picture_old = true;
  }
  ImGui::EndDisabled();
  tooltip(one_piece ? "There is only one piece: cut something off first."
                    : "Draws the pieces apart, away from the middle. They stay where they are: the next cut "
                      "draws them together again.");
  end_properties();
}

}  // namespace

void draw_pieces_panel(const World& world, ViewState& view, Requests& requests,
                       const std::function<void()>& browse_export) {
  const std::vector<PieceRow> rows = list_pieces(world, view.look.pieces);
  draw_list(view, requests, rows);
  draw_buttons(view.look.pieces, requests, browse_export);
  draw_spread(world, view, rows.size() < 2);
}

}  // namespace kerf
