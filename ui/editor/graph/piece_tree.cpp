#include "ui/editor/graph/piece_tree.h"

#include <imgui.h>

#include <algorithm>
#include <map>

#include "core/joints/loaded_part.h"
#include "ui/editor/shared/pieces/piece_set.h"
#include "ui/editor/shared/statistics/step_words.h"
#include "ui/window/fitted_text.h"
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
  explicit TreeOrder(const std::vector<PieceNode>& origins) {
    for (const PieceNode& o : origins) known_[o.piece] = true;
    for (const PieceNode& o : origins) {
      if (has_parent(o)) children_[*o.came_off].push_back(o);
    }
    for (auto& [parent, children] : children_)
      std::stable_sort(children.begin(), children.end(),
                       [](const PieceNode& a, const PieceNode& b) { return a.step < b.step; });
    for (const PieceNode& o : origins) {
      if (!has_parent(o)) add(o, o.came_off ? 1 : 0);
    }
  }
  std::vector<PieceTreeRow> take() { return std::move(rows_); }

 private:
  // A piece of which nothing is left has no row.
  bool has_parent(const PieceNode& o) const { return o.came_off && known_.contains(*o.came_off); }
  void add(const PieceNode& origin, int depth) {
    rows_.push_back({origin, depth});
    const auto found = children_.find(origin.piece);
    if (found == children_.end()) return;
    for (const PieceNode& child : found->second) add(child, depth + 1);
  }

  std::map<PieceId, bool> known_;
  std::map<PieceId, std::vector<PieceNode>> children_;
  std::vector<PieceTreeRow> rows_;
};

ImU32 colour_of_piece(const World& world, const ViewState& view, const PieceId& id) {
  const auto look = view.look.pieces.find(id);
  const bool numbered = look != view.look.pieces.end() && look->second.number != 0;
  const bool part = is_loaded_part(world.body(id.body), id.label);
  const uint32_t number = part ? 0 : numbered ? look->second.number : id.label;
  const Vec3 c = strong_piece_colour(number);
  return ImGui::ColorConvertFloat4ToU32(
      {static_cast<float>(c.x), static_cast<float>(c.y), static_cast<float>(c.z), 1});
}

std::string origin_words(const PieceNode& node, const Document& document, FileUnit unit) {
  const Body& body = document.world().body(node.piece.body);
  if (is_loaded_part(body, node.piece.label)) return "is a part that no cut separated";
  if (!node.came_off)
    return node.piece.label == 0 ? "is what is left of its body" : "came off in a step that is not known";
  const PieceId from = *node.came_off;
  const std::string name = document.world().contains(from.body)
                               ? document.world().body(from.body).name_of(from.label)
                               : "a piece that is deleted";
  const std::string did = step_words(document.history(), node.step, unit);
  return "came off " + name + " in step " + std::to_string(node.step + 1) + " (" + did + ")";
}

std::string holder_words(const PieceNode& node) {
  const std::string parts = grouped(node.parts) + " parts";
  switch (node.held_by) {
    case Holder::kNothing:
      return node.beside > 0 ? "Nothing holds it: it stays until it is moved or time passes."
                             : "Nothing holds it: it is a body of its own.";
    case Holder::kItself:
      return "It hangs together as one part.";
    case Holder::kBody:
      return "Its " + parts + " never hung together; they move as one because they are one body.";
    case Holder::kPin:
      return node.parts > 1 ? "Its " + parts + " are one body, which is pinned."
                            : "Its body is pinned: it stays whatever acts on it.";
  }
  return "";
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
  list.AddCircleFilled({x, y}, 0.32f * em, colour_of_piece(document.world(), view, id));
  ImGui::SetCursorScreenPos({x + 0.8f * em, at.y});
  if (ImGui::Selectable(fitted_label(body.name_of(id.label), ImGui::GetContentRegionAvail().x).c_str(),
                        chosen, ImGuiSelectableFlags_SpanAllColumns)) {
    choose_piece(view.look.pieces, id, ImGui::GetIO().KeyShift);
    view.picture_old = true;
  }
  mark_last_item("piece node", static_cast<int>(id.label));
  if (!chosen) tooltip(words_on(row.origin, document, view.frame.unit).c_str());
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(row.origin.came_off ? ("step " + std::to_string(row.origin.step + 1)).c_str() : "");
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(name_of(row.origin.held_by));
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(grouped(body.pieces[id.label].faces).c_str());
}

// What is to be known of the chosen piece.
void draw_words(const std::vector<PieceTreeRow>& rows, const Document& document, const ViewState& view) {
  const std::optional<PieceId> chosen = first_chosen(view.look.pieces);
  const auto row =
      std::find_if(rows.begin(), rows.end(), [&](const PieceTreeRow& r) { return r.origin.piece == chosen; });
  if (row == rows.end()) return;
  ImGui::TextWrapped("%s", words_on(row->origin, document, view.frame.unit).c_str());
  mark_last_item("piece words");
}

}  // namespace

std::string words_on(const PieceNode& node, const Document& document, FileUnit unit) {
  const std::string name = document.world().body(node.piece.body).name_of(node.piece.label);
  const std::string others = node.piece.label != 0 || node.beside == 0 ? ""
                             : node.beside == 1
                                 ? " One piece that came off still stands with it."
                                 : " " + grouped(node.beside) + " pieces that came off still stand with it.";
  return name + " " + origin_words(node, document, unit) + ". " + holder_words(node) + others;
}

std::vector<PieceTreeRow> piece_tree(const std::vector<PieceNode>& origins) {
  return TreeOrder(origins).take();
}

void draw_piece_tree(const std::vector<PieceTreeRow>& rows, const Document& document, ViewState& view) {
  constexpr ImGuiTableFlags kList =
      ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersOuter;
  const auto lines = static_cast<float>(std::clamp<size_t>(rows.size() + 1, 2, kRowsInSight));
  const float height = lines * (ImGui::GetTextLineHeight() + 2 * ImGui::GetStyle().CellPadding.y);
  if (!ImGui::BeginTable("piece nodes", 4, kList, {0, height})) return;
  ImGui::TableSetupColumn("Piece", ImGuiTableColumnFlags_WidthStretch);
  ImGui::TableSetupColumn("Came off", ImGuiTableColumnFlags_WidthFixed);
  ImGui::TableSetupColumn("Held by", ImGuiTableColumnFlags_WidthFixed);
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
  draw_words(rows, document, view);
}

}  // namespace kerf
