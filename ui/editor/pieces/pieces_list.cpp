#include "ui/editor/pieces/pieces_list.h"

#include <GLFW/glfw3.h>
#include <imgui.h>
#include <algorithm>
#include <map>
#include <utility>

#include "core/base/assert.h"
#include "core/document/cut_effects.h"
#include "core/mesh/measures.h"
#include "ui/editor/shared/file_frames.h"
#include "ui/editor/shared/panel_rows.h"
#include "ui/editor/shared/user_input.h"
#include "ui/editor/shared/viewport_pointer.h"
#include "ui/editor/shared/world_changes.h"
#include "ui/render/bodies/body_picture.h"
#include "ui/render/view/colours.h"
#include "ui/window/layout.h"
#include "ui/window/number_text.h"
#include "ui/window/theme.h"
#include "ui/window/widgets.h"

namespace kerf {

namespace {

std::vector<BodyId> hidden_bodies(const World& world) {
  std::vector<BodyId> hidden;
  for (const BodyId id : world.ids()) {
    if (world.body(id).hidden) hidden.push_back(id);
  }
  return hidden;
}

constexpr float kIconLine = 1.4f;
constexpr float kBetween = 0.35f;  // gap between two switches, in text sizes

struct Cell {
  ImVec2 middle;
  float radius = 0;
  bool clicked = false, hovered = false;
};

Cell cell(const char* id, const char* meaning) {
  const float side = ImGui::GetTextLineHeight();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  Cell cell;
  cell.clicked = ImGui::InvisibleButton(id, {side, side});
  cell.hovered = ImGui::IsItemHovered();
  cell.middle = {at.x + 0.5f * side, at.y + 0.5f * side};
  cell.radius = 0.42f * side;
  tooltip(meaning);
  return cell;
}

// Draws default states in a quiet colour, so that others stand out.
ImU32 colour_of(const Cell& cell, bool is_emphasised) {
  return cell.hovered || is_emphasised ? colours::text() : colours::secondary();
}

void draw_eye(const Cell& cell, bool open) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 colour = colour_of(cell, !open);
  const ImVec2 m = cell.middle;
  const float r = cell.radius, lid = open ? 1.15f * r : 0.9f * r;
  if (open) {
    list.AddBezierQuadratic({m.x - r, m.y}, {m.x, m.y - lid}, {m.x + r, m.y}, colour, kIconLine);
    list.AddBezierQuadratic({m.x - r, m.y}, {m.x, m.y + lid}, {m.x + r, m.y}, colour, kIconLine);
    return list.AddCircleFilled(m, 0.3f * r, colour);
  }
  list.AddBezierQuadratic({m.x - r, m.y}, {m.x, m.y + lid}, {m.x + r, m.y}, colour, kIconLine);
  for (const float x : {-0.6f, 0.0f, 0.6f}) {
    const float from = m.y + lid * (0.5f - 0.42f * x * x);
    list.AddLine({m.x + x * r, from}, {m.x + 1.25f * x * r, from + 0.4f * r}, colour, kIconLine);
  }
}

// Draws a pin: upright if pinned, else an outline lying aside.
void draw_pin(const Cell& cell, bool pinned) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 colour = colour_of(cell, pinned);
  const ImVec2 m = cell.middle;
  const float r = cell.radius;
  const ImVec2 head{m.x, m.y - 0.4f * r};
  if (pinned) {
    list.AddCircleFilled(head, 0.55f * r, colour);
  } else {
    list.AddCircle(head, 0.5f * r, colour, 0, kIconLine);
  }
  list.AddLine({m.x, head.y + 0.5f * r}, {m.x, m.y + r}, colour, kIconLine);
}

constexpr size_t kRowsInSight = 8;   // visible at once
constexpr int kMaxUnseenFrames = 6;  // until the name field is in view

void draw_swatch(const Vec3& c) {
  const float side = 0.8f * ImGui::GetFontSize();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float y = at.y + 0.5f * (ImGui::GetTextLineHeight() - side);
  const ImU32 colour = ImGui::ColorConvertFloat4ToU32(
      {static_cast<float>(c.x), static_cast<float>(c.y), static_cast<float>(c.z), 1});
  ImGui::GetWindowDrawList()->AddRectFilled({at.x, y}, {at.x + side, y + side}, colour, 2);
  ImGui::Dummy({side, ImGui::GetTextLineHeight()});
  ImGui::SameLine();
}

// Returns the colour of the piece in the viewport (sRGB, 0 .. 1), slightly brighter; grey for a piece with
// paint.
Vec3 swatch_colour(const Workspace& workspace, const PieceRow& row) {
  if (row.number == 0 || workspace.view.look.show.pieces) return strong_piece_colour(row.number);
  const Body& body = workspace.world().body(row.id.body);
  const std::vector<glm::dvec3> colours = piece_colours(body.material_names, workspace.session.paints);
  return screen_from_linear(glm::min(1.6 * colours[(row.number - 1) % colours.size()], 1.0));
}

float width_of(const std::string& text) { return ImGui::CalcTextSize(text.c_str()).x; }

// Shortens the text with three dots to fit `room`.
std::string shortened(std::string text, float room) {
  if (width_of(text) <= room) return text;
  while (!text.empty() && width_of(text + "...") > room) {
    while (text.size() > 1 && (static_cast<unsigned char>(text.back()) & 0xc0) == 0x80) text.pop_back();
    text.pop_back();
  }
  return text + "...";
}

// The columns of numbers are as wide as their widest number; names get the rest.
void set_up_columns(const std::vector<PieceRow>& rows, FileUnit unit) {
  const float arrow = ImGui::GetFontSize();  // of the column that sorts
  float faces = width_of("Faces") + arrow, area = width_of("Area") + arrow;
  size_t all_faces = 0;
  for (const PieceRow& row : rows) {
    all_faces += row.faces;
    area = std::max(area, width_of(area_label(row.area, unit)));
  }
  faces = std::max(faces, width_of(grouped(all_faces)));
  ImGui::TableSetupScrollFreeze(0, 1);
  constexpr ImGuiTableColumnFlags kNumbers =
      ImGuiTableColumnFlags_WidthFixed | ImGuiTableColumnFlags_PreferSortDescending;
  const auto set_up = [](const char* name, ImGuiTableColumnFlags flags, float width, PieceColumn column) {
    ImGui::TableSetupColumn(name, flags, width, static_cast<ImGuiID>(column));
  };
  set_up("Piece", ImGuiTableColumnFlags_WidthStretch | ImGuiTableColumnFlags_DefaultSort, 0,
         PieceColumn::kNumber);
  set_up("Faces", kNumbers, faces, PieceColumn::kFaces);
  set_up("Area", kNumbers, area, PieceColumn::kArea);
  ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed | ImGuiTableColumnFlags_NoSort,
                          width_of_switches());
  ImGui::TableHeadersRow();
}

// Sorts the pieces by the column whose header was clicked last; at first by number, so that rows stay in
// place while pieces are cut.
void sort_by_header(SortedPieces& sorted) {
  const ImGuiTableSortSpecs* specs = ImGui::TableGetSortSpecs();
  if (specs == nullptr || specs->SpecsCount == 0) return;
  const ImGuiTableColumnSortSpecs& by = specs->Specs[0];
  for (std::vector<PieceRow>* rows : {&sorted.rest, &sorted.specks})
    sort_pieces(*rows, static_cast<PieceColumn>(by.ColumnUserID),
                by.SortDirection == ImGuiSortDirection_Descending);
}

void draw_statistics(size_t faces, double area, FileUnit unit) {
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(grouped(faces).c_str());
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(area_label(area, unit).c_str());
  ImGui::TableNextColumn();
}

PieceLook look_of(const ViewState& view, const PieceId& id) {
  const auto found = view.look.pieces.find(id);
  return found != view.look.pieces.end() ? found->second : PieceLook();
}

struct Listed {
  const PieceRow* row = nullptr;  // null: the row for all specks
  bool is_folded = false;
};

std::vector<Listed> rows_to_list(const SortedPieces& sorted, bool specks_unfolded) {
  std::vector<Listed> listed;
  for (const PieceRow& row : sorted.rest) listed.push_back({&row, false});
  if (!sorted.specks.empty()) listed.push_back({});
  for (size_t i = 0; specks_unfolded && i < sorted.specks.size(); ++i)
    listed.push_back({&sorted.specks[i], true});
  return listed;
}

void request_specks(Workspace& workspace, const std::vector<PieceId>& specks, bool hide) {
  const char* name = hide ? "Hide specks" : "Show specks";
  const auto run = [&workspace, specks, name, hide] {
    cancel_stroke(workspace);
    workspace.changes.change(name, is_small(workspace.session.document),
                             edit_all(specks, [hide](const PieceId& piece) {
                               return HidePiece{piece, hide};
                             }));
    return true;
  };
  workspace.changes.enqueue({.name = name, .run = run, .is_one = true});
}

}  // namespace

std::vector<PieceId> Isolation::to_show_again() const {
  std::vector<PieceId> pieces;
  for (const PieceId& piece : hidden_pieces(workspace_.view.look.pieces)) {
    const auto found = std::find(isolated_from_.begin(), isolated_from_.end(), piece.body);
    if (workspace_.world().contains(piece.body) && found != isolated_from_.end()) pieces.push_back(piece);
  }
  return pieces;
}

const char* Isolation::disabled_reason() const {
  if (!to_show_again().empty()) return nullptr;
  if (const char* why = no_selection_reason(workspace_.view.look.pieces)) return why;
  return other_pieces(workspace_.world(), workspace_.view.look.pieces).empty() ? "All pieces are selected."
                                                                               : nullptr;
}

void Isolation::change() {
  std::vector<PieceId> pieces = to_show_again();
  const bool hide = pieces.empty();
  if (hide) {
    pieces = other_pieces(workspace_.world(), workspace_.view.look.pieces);
    hidden_before_ = hidden_bodies(workspace_.world());
  }
  cancel_stroke(workspace_);
  workspace_.changes.change(hide ? "Isolate pieces" : "Show other pieces",
                            is_small(workspace_.session.document),
                            edit_all(std::move(pieces), [hide](const PieceId& piece) {
                              return HidePiece{piece, hide};
                            }));
}

void Isolation::follow() {
  if (!hidden_before_ && isolated_from_.empty()) return;
  const std::vector<BodyId> hidden = hidden_bodies(workspace_.world());
  const auto among = [](const std::vector<BodyId>& ids) {
    return [&ids](const BodyId& id) { return std::ranges::find(ids, id) != ids.end(); };
  };
  if (hidden_before_) {
    isolated_from_ = hidden;
    std::erase_if(isolated_from_, among(*hidden_before_));
    hidden_before_.reset();
    is_over_ = false;
  } else if (std::ranges::all_of(isolated_from_, among(hidden))) {
    is_over_ = false;  // a redo, or an undo of showing them
  } else if (std::ranges::none_of(isolated_from_, among(hidden))) {
    is_over_ = true;
  } else if (is_over_) {
    isolated_from_.clear();
  }
}

bool eye_switch(bool open, const char* meaning) {
  const Cell at = cell("##eye", meaning);
  draw_eye(at, open);
  return at.clicked;
}

bool pin_switch(bool pinned, const char* meaning) {
  ImGui::SameLine(0, kBetween * ImGui::GetFontSize());
  const Cell at = cell("##pin", meaning);
  draw_pin(at, pinned);
  return at.clicked;
}

float width_of_switches() { return 2 * ImGui::GetTextLineHeight() + kBetween * ImGui::GetFontSize(); }

void PiecesList::begin_rename(const PieceRow& row) {
  renamed_ = row.id;
  take_focus_ = field_drawn_ = true;
  unseen_frames_ = 0;
  fill_field(new_name_, row.name);
  old_name_ = new_name_.data();
}

void PiecesList::begin_asked_rename(const SortedPieces& sorted) {
  const std::optional<PieceId> asked = std::exchange(asked_, {});
  if (!asked) return;
  for (const std::vector<PieceRow>* rows : {&sorted.rest, &sorted.specks}) {
    for (const PieceRow& row : *rows) {
      if (row.id != *asked) continue;
      specks_unfolded_ = specks_unfolded_ || rows == &sorted.specks;
      begin_rename(row);
    }
  }
}

// Draws the field that replaces the name. Any end of the edit except Esc renames the piece.
void PiecesList::edit_name(WorldChanges& changes) {
  field_drawn_ = true;
  if (take_focus_) ImGui::SetKeyboardFocusHere();
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(2, 0));
  ImGui::SetNextItemWidth(-1);
  const bool entered =
      ImGui::InputText("##name", new_name_.data(), new_name_.size(),
                       ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  ImGui::PopStyleVar();
  if (ImGui::IsItemActive()) mark_last_item("new name");
  const bool over = entered || (!take_focus_ && !ImGui::IsItemActive());
  take_focus_ = take_focus_ && !ImGui::IsItemActive();
  if (over) take_new_name(changes);
}

void PiecesList::take_new_name(WorldChanges& changes) {
  KERF_ASSERT(renamed_);
  const PieceId piece = *std::exchange(renamed_, std::nullopt);
  take_focus_ = false;
  const std::string name = new_name_.data();
  if (!name.empty() && name != old_name_) changes.enqueue(RenamePiece{piece, name});
}

void PiecesList::forget_rename() {
  asked_.reset();
  renamed_.reset();
  take_focus_ = false;
}

void PiecesList::end_hidden_edit(Workspace& workspace) {
  const bool drawn = std::exchange(field_drawn_, false);
  if (!asked_ && !renamed_) return;
  if (renamed_ && !take_focus_ && !drawn) return take_new_name(workspace.changes);
  if (!awaits_focus() || ++unseen_frames_ <= kMaxUnseenFrames) return;
  forget_rename();
  workspace.message.error("The list of pieces does not fit: enlarge the window to rename a piece.");
}

void PiecesList::draw_name(ViewState& view, const PieceRow& row, const PieceLook& look) {
  if (look.selected) ImGui::PushStyleColor(ImGuiCol_Text, colours::accent());
  if (look.hidden) ImGui::PushStyleColor(ImGuiCol_Text, colours::secondary());
  const float room = ImGui::GetContentRegionAvail().x;
  const std::string label = whole_label(shortened(row.name, room)) + "###name";
  const bool clicked =
      ImGui::Selectable(label.c_str(), look.selected, ImGuiSelectableFlags_AllowDoubleClick, {room, 0});
  if (look.hidden) ImGui::PopStyleColor();
  if (look.selected) ImGui::PopStyleColor();
  tooltip(
      (row.name + ". Click to select, Ctrl+click or Shift+click to add, double-click to rename.").c_str());
  if (!clicked) return;
  if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
    begin_rename(row);
  }
  if (look.hidden || renamed_) return;
  const ImGuiIO& io = ImGui::GetIO();
  select_piece(view.look.pieces, row.id, io.KeyCtrl || io.KeyShift);
  view.picture_old = true;
}

void PiecesList::draw_switches(WorldChanges& changes, const PieceRow& row, bool hidden) {
  if (eye_switch(!hidden, hidden ? "Shows this piece again." : "Hides this piece; the beam does not cut it."))
    changes.enqueue(HidePiece{row.id, !hidden});
  mark_last_item(("eye " + row.name).c_str());
  if (pin_switch(row.pinned, row.pinned ? "Releases this piece so that it moves again."
                                        : "Fixes this piece in place while others move."))
    changes.enqueue(PinPiece{row.id, !row.pinned});
  mark_last_item(("pin " + row.name).c_str());
}

void PiecesList::draw_row(Workspace& workspace, const PieceRow& row, bool is_folded) {
  ViewState& view = workspace.view;
  const PieceLook look = look_of(view, row.id);
  ImGui::PushID(static_cast<int>(row.id.body.slot));
  ImGui::PushID(static_cast<int>(row.id.label));
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  if (is_folded) ImGui::Indent();
  draw_swatch(swatch_colour(workspace, row));
  if (renamed_ == row.id) {
    edit_name(workspace.changes);
  } else {
    draw_name(view, row, look);
  }
  mark_last_item(("piece " + row.name).c_str());
  if (is_folded) ImGui::Unindent();
  draw_statistics(row.faces, row.area, view.frame.unit);
  draw_switches(workspace.changes, row, look.hidden);
  ImGui::PopID();
  ImGui::PopID();
}

void PiecesList::draw_specks(Workspace& workspace, const std::vector<PieceRow>& specks) {
  size_t faces = 0;
  double area = 0;
  bool selected = false;
  std::vector<PieceId> shown, hidden;
  for (const PieceRow& row : specks) {
    const PieceLook look = look_of(workspace.view, row.id);
    faces += row.faces;
    area += row.area;
    selected = selected || look.selected;
    (look.hidden ? hidden : shown).push_back(row.id);
  }
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::SetNextItemOpen(specks_unfolded_, ImGuiCond_Always);
  if (selected) ImGui::PushStyleColor(ImGuiCol_Text, colours::accent());
  const std::string label = grouped(specks.size()) + " specks###specks";
  specks_unfolded_ = ImGui::TreeNodeEx(
      label.c_str(), ImGuiTreeNodeFlags_NoTreePushOnOpen | ImGuiTreeNodeFlags_SpanAvailWidth);
  if (selected) ImGui::PopStyleColor();
  mark_last_item("specks");
  tooltip("Pieces smaller than an eighth of the beam's cross-section when cut off. Click to list them.");
  draw_statistics(faces, area, workspace.view.frame.unit);
  const bool hides = !shown.empty();
  if (eye_switch(hides, hides ? "Hides all specks; the beam does not cut them." : "Shows all specks again."))
    request_specks(workspace, hides ? shown : hidden, hides);
  mark_last_item("eye specks");
}

void PiecesList::draw_rows(Workspace& workspace, const SortedPieces& sorted) {
  const std::vector<Listed> listed = rows_to_list(sorted, specks_unfolded_);
  const auto draw_one = [&](const Listed& each) {
    if (each.row == nullptr) return draw_specks(workspace, sorted.specks);
    draw_row(workspace, *each.row, each.is_folded);
  };
  // A field that needs the focus must be drawn even if it is scrolled out of view.
  if (take_focus_) {
    std::for_each(listed.begin(), listed.end(), draw_one);
    return;
  }
  draw_rows_in_sight(listed.size(), [&](size_t i) { draw_one(listed[i]); });
}

void PiecesList::draw(Workspace& workspace, const std::vector<PieceRow>& rows) {
  constexpr ImGuiTableFlags kList = ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg |
                                    ImGuiTableFlags_NoPadOuterX | ImGuiTableFlags_Sortable;
  SortedPieces sorted = separate_specks(rows, specks(workspace.session.document));
  begin_asked_rename(sorted);
  const size_t count = rows_to_list(sorted, specks_unfolded_).size();
  const float height = height_of_rows(std::min(count, kRowsInSight) + 1);
  if (!ImGui::BeginTable("pieces", 4, kList, {0, height})) return;
  set_up_columns(rows, workspace.view.frame.unit);
  sort_by_header(sorted);
  draw_rows(workspace, sorted);
  ImGui::EndTable();
}

namespace {

void add_measures(const Body& body, const std::vector<bool>& is_measured, PieceMeasures& measures) {
  const Mesh& mesh = body.mesh;
  std::vector<FaceId> faces;
  for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
    if (mesh.is_live(FaceId(f)) && is_measured[mesh.data(FaceId(f)).piece]) faces.emplace_back(f);
  }
  for (const FaceId face : faces) measures.area += triangle_area(mesh.triangle(face));
  const std::vector<bool> closed = closed_pieces(mesh, faces, body.pieces.size());
  for (size_t label = 0; label < closed.size(); ++label) {
    if (is_measured[label] && !closed[label]) measures.volume.reset();
  }
  if (measures.volume)
    *measures.volume += enclosed_volume(mesh, faces, mesh.triangle(faces.front())[0]).volume;
}

}  // namespace

PieceMeasures measure_pieces(const World& world, const std::vector<PieceId>& pieces) {
  PieceMeasures measures{.pieces = pieces.size(), .volume = 0.0};
  std::map<BodyId, std::vector<bool>> bodies;  // by label: true if measured
  for (const PieceId& id : pieces) {
    std::vector<bool>& is_measured = bodies[id.body];
    is_measured.resize(world.body(id.body).pieces.size());
    is_measured[id.label] = true;
  }
  for (const auto& [id, is_measured] : bodies) add_measures(world.body(id), is_measured, measures);
  return measures;
}

const PieceMeasures& SelectionMeasures::follow(const Document& document, const PieceMap& looks) {
  const World& world = document.world();
  std::vector<PieceId> pieces = selected_ids(looks);
  std::vector<Surface> surfaces;
  for (const PieceId& id : pieces) {
    const Piece& piece = world.body(id.body).pieces[id.label];
    surfaces.push_back({piece.faces, piece.area});
  }
  const bool waits = document.waiting() > 0 && !document.queue().only_cools();
  if (measured_ && pieces == pieces_ && (waits || surfaces == surfaces_)) return *measured_;
  pieces_ = std::move(pieces);
  surfaces_ = std::move(surfaces);
  return measured_.emplace(measure_pieces(world, pieces_));
}

void draw_measures(const PieceMeasures& measures, FileUnit unit) {
  if (measures.pieces == 0) return;
  secondary_text(count_text(measures.pieces, "piece") + ": area " + area_label(measures.area, unit) + ", " +
                 (measures.volume ? "volume " + volume_label(*measures.volume, unit) : "open"));
  mark_last_item("selection measures");
  tooltip("Area and volume of the selected pieces. A piece with an open edge encloses no volume.");
}

}  // namespace kerf
