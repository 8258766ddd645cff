#include "ui/editor/graph/piece_tree.h"

#include <imgui.h>

#include <algorithm>
#include <map>

#include "core/document/command_words.h"
#include "ui/editor/view/piece_set.h"
#include "ui/window/landmarks.h"
#include "ui/window/number_text.h"
#include "ui/window/property.h"
#include "ui/window/theme.h"

namespace kerf {

namespace {

constexpr size_t kMostRows = 500, kRowsInSight = 14;

// Depth-first, and the pieces of one parent by step.
class TreeOrder {
 public:
  explicit TreeOrder(const std::vector<PieceOrigin>& origins) {
    for (const PieceOrigin& o : origins) known_[o.piece] = true;
    for (const PieceOrigin& o : origins) {
      if (has_parent(o)) children_[*o.came_off].push_back(o);
    }
    for (auto& [parent, children] : children_)
      std::stable_sort(children.begin(), children.end(),
                       [](const PieceOrigin& a, const PieceOrigin& b) { return a.step < b.step; });
    for (const PieceOrigin& o : origins) {
      if (!has_parent(o)) add(o, o.came_off ? 1 : 0);
    }
  }
  std::vector<PieceTreeRow> take() { return std::move(rows_); }

 private:
  // A piece of which nothing is left has no row.
  bool has_parent(const PieceOrigin& o) const { return o.came_off && known_.contains(*o.came_off); }
  void add(const PieceOrigin& origin, int depth) {
    rows_.push_back({origin, depth});
    const auto found = children_.find(origin.piece);
    if (found == children_.end()) return;
    for (const PieceOrigin& child : found->second) add(child, depth + 1);
  }

  std::map<PieceId, bool> known_;
  std::map<PieceId, std::vector<PieceOrigin>> children_;
  std::vector<PieceTreeRow> rows_;
};

ImU32 colour_of_piece(const ViewState& view, const PieceId& id) {
  const auto look = view.look.pieces.find(id);
  const uint32_t number =
      look != view.look.pieces.end() && look->second.number != 0 ? look->second.number : id.label;
  const Vec3 c = piece_colour(number, true);
  return ImGui::ColorConvertFloat4ToU32(
      {static_cast<float>(c.x), static_cast<float>(c.y), static_cast<float>(c.z), 1});
}

std::string origin_text(const PieceOrigin& origin, const Document& document) {
  if (!origin.came_off)
    return origin.piece.label == 0 ? "what is left of the body" : "it is not known what it came off";
  const PieceId from = *origin.came_off;
  const std::string name = document.world().contains(from.body)
                               ? document.world().body(from.body).name_of(from.label)
                               : "a piece that is deleted";
  return "came off " + name + " in step " + std::to_string(origin.step + 1);
}

void draw_row(const PieceTreeRow& row, const Document& document, ViewState& view) {
  const PieceId id = row.origin.piece;
  const Body& body = document.world().body(id.body);
  const float em = ImGui::GetFontSize(), line = ImGui::GetTextLineHeight();
  const auto look = view.look.pieces.find(id);
  const bool chosen = look != view.look.pieces.end() && look->second.selected;
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float x = at.x + em * (0.5f + static_cast<float>(row.depth)), y = at.y + 0.5f * line;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (row.depth > 0) {
    list.AddLine({x - em, at.y - 0.3f * line}, {x - em, y}, colours::secondary());
    list.AddLine({x - em, y}, {x - 0.4f * em, y}, colours::secondary());
  }
  list.AddCircleFilled({x, y}, 0.32f * em, colour_of_piece(view, id));
  ImGui::SetCursorScreenPos({x + 0.8f * em, at.y});
  if (ImGui::Selectable(body.name_of(id.label).c_str(), chosen, ImGuiSelectableFlags_SpanAllColumns)) {
    choose_piece(view.look.pieces, id, ImGui::GetIO().KeyShift);
    view.picture_old = true;
  }
  mark_last_item("piece node", static_cast<int>(id.label));
  const std::string step =
      row.origin.came_off ? words(document.history().step(row.origin.step).commands().front()) : "";
  tooltip((origin_text(row.origin, document) + (step.empty() ? "" : ": " + step)).c_str());
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(row.origin.came_off ? ("step " + std::to_string(row.origin.step + 1)).c_str() : "");
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(grouped(body.pieces[id.label].faces).c_str());
}

}  // namespace

std::vector<PieceTreeRow> piece_tree(const std::vector<PieceOrigin>& origins) {
  return TreeOrder(origins).take();
}

void draw_piece_tree(const std::vector<PieceTreeRow>& rows, const Document& document, ViewState& view) {
  constexpr ImGuiTableFlags kList =
      ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersOuter;
  const auto lines = static_cast<float>(std::clamp<size_t>(rows.size() + 1, 2, kRowsInSight));
  const float height = lines * (ImGui::GetTextLineHeight() + 2 * ImGui::GetStyle().CellPadding.y);
  if (!ImGui::BeginTable("piece nodes", 3, kList, {0, height})) return;
  ImGui::TableSetupColumn("Piece", ImGuiTableColumnFlags_WidthStretch);
  ImGui::TableSetupColumn("Came off", ImGuiTableColumnFlags_WidthFixed);
  ImGui::TableSetupColumn("Faces", ImGuiTableColumnFlags_WidthFixed);
  ImGui::TableSetupScrollFreeze(0, 1);
  ImGui::TableHeadersRow();
  for (size_t i = 0; i < std::min(rows.size(), kMostRows); ++i) {
    ImGui::PushID(static_cast<int>(i));
    draw_row(rows[i], document, view);
    ImGui::PopID();
  }
  ImGui::EndTable();
  if (rows.size() > kMostRows)
    ImGui::TextDisabled("%s more are not listed.", grouped(rows.size() - kMostRows).c_str());
}

}  // namespace kerf
