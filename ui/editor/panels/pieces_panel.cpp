#include "ui/editor/panels/pieces_panel.h"

#include <imgui.h>

#include "ui/editor/view/piece_set.h"
#include "ui/editor/view/shortcut_text.h"
#include "ui/render/spread.h"
#include "ui/window/number_format.h"
#include "ui/window/property.h"
#include "ui/window/row_button.h"

namespace kerf {

namespace {

constexpr double kMostSpread = 1.5;

void draw_buttons(const ViewState& view, Requests& requests, const std::function<void()>& browse_export) {
  const PieceMap& looks = view.look.pieces;
  const size_t chosen = chosen_pieces(looks), hidden = hidden_pieces(looks).size();
  constexpr const char* kNoneChosen =
      "No piece is chosen: Ctrl+click one in the picture, or click it in the list.";
  const char* why_none = chosen > 0 ? nullptr : kNoneChosen;
  const auto told = [&](const char* meaning, const char* action) {
    return with_shortcut(view, meaning, action);
  };
  if (row_button("Hide", 3, why_none,
                 told("Leaves the chosen pieces out of the picture.", "Hide the chosen").c_str()))
    requests.hide_chosen = true;
  ImGui::SameLine();
  if (row_button("Show all", 3, hidden > 0 ? nullptr : "No piece is hidden.",
                 told("Draws the hidden pieces again.", "Show all pieces").c_str()))
    requests.show_hidden = true;
  ImGui::SameLine();
  if (row_button("Export", 3, why_none,
                 told("Writes the chosen pieces to mesh files.", "Export chosen pieces...").c_str()))
    browse_export();
}

void draw_spread(const World& world, ViewState& view, bool one_piece) {
  if (!begin_properties("spread")) return;
  property("Spread");
  constexpr double kNone = 0;
  ImGui::BeginDisabled(one_piece);
  const RealFormat format = view.spread == 0 ? RealFormat("together") : RealFormat("%.2f");
  if (ImGui::SliderScalar("##spread", ImGuiDataType_Double, &view.spread, &kNone, &kMostSpread,
                          format.c_str(), ImGuiSliderFlags_AlwaysClamp)) {
    spread_further(world, view.spread, view.look);
    view.picture_old = true;
  }
  ImGui::EndDisabled();
  tooltip(one_piece ? "There is only one piece: cut something off first."
                    : "Draws the pieces apart, away from the middle. They stay where they are: the next cut "
                      "draws them together again.");
  end_properties();
}

}  // namespace

void PiecesPanel::draw(const World& world, ViewState& view, Requests& requests,
                       const std::function<void()>& browse_export) {
  const std::vector<PieceRow> rows = list_pieces(world, view.look.pieces);
  list_.draw(view, requests, rows);
  draw_buttons(view, requests, browse_export);
  placement_.draw(world, view, requests);
  draw_spread(world, view, rows.size() < 2);
}

}  // namespace kerf
