#include "ui/editor/pieces/pieces_feature.h"

#include <GLFW/glfw3.h>
#include <imgui.h>
#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <set>

#include "core/base/assert.h"
#include "core/base/json.h"
#include "core/base/platform.h"
#include "core/document/extract.h"
#include "core/document/lost_looks.h"
#include "core/document/piece_looks.h"
#include "core/document/surface_files.h"
#include "core/mesh/files/encode.h"
#include "core/mesh/looks.h"
#include "core/mesh/mesh_file.h"
#include "ui/editor/pieces/area_selection.h"
#include "ui/editor/pieces/pieces_list.h"
#include "ui/editor/shared/feature.h"
#include "ui/editor/shared/panel_rows.h"
#include "ui/editor/shared/viewport_pointer.h"
#include "ui/editor/shared/world_changes.h"
#include "ui/render/view/view_options.h"
#include "ui/window/widgets.h"

namespace kerf {

namespace fs = std::filesystem;

namespace {

// Converts linear light to sRGB, as stored in files, rounded to four digits.
double to_srgb(double x) {
  x = std::clamp(x, 0.0, 1.0);
  const double shown = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
  return std::round(1e4 * shown) / 1e4;
}

bool has_materials(const Body& body) {
  return std::any_of(body.material_names.begin(), body.material_names.end(),
                     [](const std::string& name) { return !name.empty(); });
}

std::string replaced(std::string text, const std::string& name) {
  for (size_t at = 0; (at = text.find('*', at)) != std::string::npos; at += name.size())
    text.replace(at, 1, name);
  return text;
}

fs::path with_suffix(const fs::path& file, const std::string& suffix) {
  return file.parent_path() / (file.stem().string() + suffix + file.extension().string());
}

std::string materials_text(const Extract& extract, const std::vector<std::string>& names,
                           const std::map<std::string, Paint>& paints) {
  std::set<uint16_t> used(extract.materials.begin(), extract.materials.end());
  std::vector<MaterialLook> looks;
  for (const uint16_t material : used) {
    KERF_ASSERT(material < names.size());
    const auto found = paints.find(names[material]);
    const Paint paint = found != paints.end() ? found->second : Paint();
    const Vec3& c = paint.colour;
    looks.push_back({names[material], {to_srgb(c.x), to_srgb(c.y), to_srgb(c.z)}, paint.gloss});
  }
  return encode_mtl(looks);
}

const SurfaceLibrary* surfaces_of(const Body& body) {
  return body.looks ? body.looks->surfaces().get() : nullptr;
}

// Writes pieces in one format, and collects what that loses.
class PieceWriter {
 public:
  PieceWriter(const World& world, const std::map<std::string, Paint>& paints, MeshFormat format)
      : world_(world), paints_(paints), format_(format) {}

  // Writes the materials that the mesh files describe, for OBJ.
  Status write_surfaces(std::span<const PieceFile> files, const fs::path& folder) {
    std::set<BodyId> bodies;
    for (const PieceFile& to : files) {
      const Body& body = world_.body(to.piece.body);
      if (surfaces_of(body) && bodies.insert(to.piece.body).second) surfaces_.add(body);
    }
    return format_ == MeshFormat::kObj ? surfaces_.write(folder) : Status(Done{});
  }

  // Writes each piece to its file, or all to the first one. Precondition: write_surfaces() has succeeded.
  Status write(std::span<const PieceFile> files) {
    const bool single = files.size() > 1 && files[0].mesh == files[1].mesh;
    std::deque<Piece> pieces;
    std::vector<MeshView> views;
    for (const PieceFile& to : files) {
      const Piece& piece = pieces.emplace_back(*this, to);
      if (!to.mtl.empty()) {
        const Status written = write_file_atomically(
            to.mtl, materials_text(piece.extract, world_.body(to.piece.body).material_names, paints_));
        if (!written) return written;
      }
      if (single) {
        views.push_back(piece.view);
        continue;
      }
      if (const Status written = write_mesh(piece.view, to.mesh, format_); !written) return written;
      pieces.clear();
    }
    return single ? write_meshes(views, files[0].mesh, format_) : Status(Done{});
  }

  // Returns sentences for the user, each without its full stop; nullopt if nothing was lost.
  std::optional<std::string> note() const {
    std::vector<std::string> notes;
    lost_.add_notes(format_, notes);
    if (const auto note = precision_note(precision_, format_, "export OBJ, PLY or OFF"))
      notes.push_back(*note);
    if (notes.empty()) return std::nullopt;
    std::string text;
    for (const std::string& note : notes) text += (text.empty() ? "" : ". ") + note;
    return text;
  }

 private:
  // A piece to be written. The view refers to the other members.
  struct Piece {
    Extract extract;
    CornerLooks looks;
    std::string mtl;
    MeshView view;

    Piece(PieceWriter& writer, const PieceFile& to) : mtl(to.mtl.filename().string()) {
      const Body& body = writer.world_.body(to.piece.body);
      const MeshFormat format = writer.format_;
      const std::vector<FaceId>& faces = writer.faces_of(to.piece);
      extract = extract_faces(body, faces);
      view = {extract.positions, extract.triangles, extract.materials, body.material_names, mtl,
              to.name,           extract.colours};
      if (format_row(format).uvs_and_normals)
        looks = looks_of(body, faces, is_gltf(format) ? LookNormals::kAll : LookNormals::kSmooth);
      if (looks.any()) view.looks = &looks;
      view.surfaces = surfaces_of(body);
      if (view.surfaces && !writer.surfaces_.mtl_name().empty()) {
        view.mtl = writer.surfaces_.mtl_name();
        view.material_names = writer.surfaces_.names(body);
      }
      writer.precision_ += precision_loss(view, format);
      writer.lost_.add(body, faces, extract, format);
    }
    Piece(const Piece&) = delete;
    Piece& operator=(const Piece&) = delete;
  };

  // Lists the faces of all pieces of a body when the first one is written.
  const std::vector<FaceId>& faces_of(const PieceId& piece) {
    std::vector<std::vector<FaceId>>& pieces = faces_[piece.body];
    const Body& body = world_.body(piece.body);
    const bool is_new = pieces.empty();
    pieces.resize(body.pieces.size());
    for (uint32_t f = 0; is_new && f < body.mesh.face_slots(); ++f) {
      if (body.mesh.is_live(FaceId(f))) pieces[body.mesh.data(FaceId(f)).piece].emplace_back(f);
    }
    return pieces[piece.label];
  }

  const World& world_;
  const std::map<std::string, Paint>& paints_;
  MeshFormat format_;
  SurfaceFiles surfaces_;
  PrecisionLoss precision_;
  LostLooks lost_;
  std::map<BodyId, std::vector<std::vector<FaceId>>> faces_;  // by label
};

constexpr double kSpreadStep = 0.25, kMaxSpread = 1.5;
constexpr size_t kMaxNamed = 100;  // pieces
constexpr const char* kPiecesPanel = "pieces";

constexpr double kSimilarArea = 0.1;

// The names of the materials of the faces of each piece; unnamed materials count as one.
std::map<PieceId, std::set<std::string>> materials_of_pieces(const World& world) {
  std::map<PieceId, std::set<std::string>> all;
  for (const BodyId id : world.ids()) {
    const Body& body = world.body(id);
    std::set<std::pair<uint32_t, uint16_t>> used;
    for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
      if (!body.mesh.is_live(FaceId(f))) continue;
      const FaceData& data = body.mesh.data(FaceId(f));
      if (used.emplace(data.piece, data.material).second && data.material < body.material_names.size())
        all[{id, data.piece}].insert(body.material_names[data.material]);
    }
  }
  return all;
}

class PiecesFeature : public Feature {
 public:
  explicit PiecesFeature(Workspace& workspace) : workspace_(workspace) {}

  std::vector<PanelPart> panel_parts() override {
    return {{"pieces.list", [this] { draw_list(); }},
            {"pieces.explode", [this] { draw_spread(list_pieces(workspace_.world()).size() < 2); }}};
  }
  std::vector<ToolOption> tool_options() override {
    return {{"pieces.shape", 5, [this] {
               choice_row("Shape", "##shape", shape_, "Box\0Lasso\0", "selection shape",
                          "Shape of a drag that selects pieces.");
             }}};
  }
  std::vector<UserAction> actions() override {
    return joined(
        {{tool_action(
              workspace_, kPickTool, "Select", "K",
              "Click a piece or drag around several to select; Shift adds. With the Laser, use Ctrl."),
          export_action()},
         piece_actions(),
         shown_actions()});
  }
  std::vector<Gesture> gestures() const override {
    return {{"select", "Ctrl+click", "Select a piece; Shift adds to the selection"},
            {"select_box", "Ctrl+left drag",
             "Select pieces inside a box or lasso; a box from right to left also those it touches"},
            {"select_more", "Left drag with the Select tool",
             "Select pieces inside a box or lasso; Shift adds them, Ctrl removes them"},
            {"rename", "Double click on a name in the list", "Rename the piece"}};
  }

  std::unique_ptr<Interaction> begin_interaction(const Press& press) override {
    return picks(workspace_.input, press) ? press_on_pieces(workspace_, shape_) : nullptr;
  }
  bool clear_selection() override {
    const bool any = selected_count(workspace_.view.look.pieces) > 0;
    deselect_all(workspace_.view.look.pieces);
    workspace_.view.picture_old = workspace_.view.picture_old || any;
    return any;
  }
  const char* status_hint() const override {
    if (!workspace_.input.picks()) return nullptr;
    return shape_ == SelectionShape::kLasso
               ? "Select: click or drag a lasso, Shift to add, G to move, R to rotate"
               : "Select: click or drag a box, Shift to add, G to move, R to rotate";
  }

  bool awaits_focus() const override { return list_.awaits_focus(); }
  void draw_windows() override { list_.end_hidden_edit(workspace_); }

  void on_world_changed(const Delta& delta) override {
    isolation_.follow();
    measures_.on_world_changed();
    follow_world(workspace_.world(), delta, copied_);
  }
  void on_document_opened() override {
    workspace_.view.look.pieces.clear();
    workspace_.view.numbers = PieceNumbers();
    workspace_.view.spread = 0;
    copied_.clear();
    measures_.on_world_changed();
    isolation_.forget();
    list_.forget_rename();
  }
  void write_session_log(nlohmann::ordered_json& report) const override {
    report["pieces_chosen"] = selected_count(workspace_.view.look.pieces);
    report["pieces_hidden"] = hidden_pieces(workspace_.view.look.pieces).size();
    report["spread"] = workspace_.view.spread;
  }

 private:
  std::vector<UserAction> piece_actions() {
    const auto no_emitter_reason = [this] { return no_selection_reason(workspace_.view.look.pieces); };
    const auto rename_disabled_reason = [this]() -> const char* {
      if (const char* why = no_selection_reason(workspace_.view.look.pieces)) return why;
      return selected_count(workspace_.view.look.pieces) > 1 ? "Select a single piece to rename it."
                                                             : nullptr;
    };
    return {
        UserAction{.id = "pieces.select_all",
                   .name = "Select All",
                   .shortcut = "A",
                   .also = {GLFW_KEY_A, GLFW_MOD_CONTROL},
                   .tip = "Selects all visible pieces.",
                   .run = [this] { select_if([](const PieceRow&) { return true; }); }},
        make_action("pieces.invert", "Invert Selection", "Ctrl+I",
                    "Selects the visible pieces that are not selected, and no others.",
                    [this] {
                      select_if([looks = workspace_.view.look.pieces](const PieceRow& row) {
                        const auto look = looks.find(row.id);
                        return look == looks.end() || !look->second.selected;
                      });
                    }),
        make_action("pieces.select_body", "Select Connected", "",
                    "Selects all pieces and parts of the bodies of the selected ones.",
                    [this] {
                      select_like(
                          [](const PieceRow& a, const PieceRow& b) { return a.id.body == b.id.body; });
                    },
                    {.disabled_reason = no_emitter_reason}),
        make_action("pieces.select_similar", "Select Similar Area", "",
                    "Selects all pieces whose areas differ by at most a tenth from a selected one.",
                    [this] {
                      select_like([](const PieceRow& a, const PieceRow& b) {
                        return std::abs(a.area - b.area) <= kSimilarArea * std::max(a.area, b.area);
                      });
                    },
                    {.disabled_reason = no_emitter_reason}),
        make_action("pieces.select_material", "Select Same Material", "",
                    "Selects all pieces that share a material with a selected one.",
                    [this] { select_same_material(); }, {.disabled_reason = no_emitter_reason}),
        make_action("pieces.grow", "Grow Selection", "",
                    "Adds the pieces whose rims lie across a cut from a selected piece, or touch it.",
                    [this] {
                      grow_selection(workspace_.session.document, workspace_.view.look.pieces);
                      workspace_.view.picture_old = true;
                    },
                    {.disabled_reason = no_emitter_reason}),
        make_action("pieces.shrink", "Shrink Selection", "",
                    "Deselects the pieces next to one that is not selected.",
                    [this] {
                      shrink_selection(workspace_.session.document, workspace_.view.look.pieces);
                      workspace_.view.picture_old = true;
                    },
                    {.disabled_reason = no_emitter_reason}),
        make_action("pieces.lasso", "Lasso Selection", "",
                    "A drag that selects pieces draws a closed line around them instead of a box.",
                    [this] {
                      shape_ = shape_ == SelectionShape::kBox ? SelectionShape::kLasso : SelectionShape::kBox;
                    },
                    {.checked = [this] { return shape_ == SelectionShape::kLasso; }}),
        UserAction{.id = "view.frame_selected",
                   .name = "Frame Selected",
                   .shortcut = "F",
                   .also = {GLFW_KEY_KP_DECIMAL},
                   .tip = "Fits the selected pieces, or the scene if none is selected, in the viewport.",
                   .run = [this] { frame_selected(); }},
        make_action("pieces.copy", "Copy", "Ctrl+C", "Remembers the selected pieces for Paste.",
                    [this] { copied_ = selected_ids(workspace_.view.look.pieces); },
                    {.disabled_reason = no_emitter_reason}),
        make_action(
            "pieces.paste", "Paste", "Ctrl+V", "Adds copies of the copied pieces in place and selects them.",
            [this] { request_paste(); }, {.disabled_reason = [this] { return paste_disabled_reason(); }}),
        make_action("pieces.hide", "Hide Selected", "H",
                    "Hides the selected pieces; the beam does not cut them.", [this] { request_hide(); },
                    {.disabled_reason = no_emitter_reason}),
        make_action("pieces.show_all", "Show All", "Shift+H", "Shows all hidden pieces.",
                    [this] { request_show(); }, {.disabled_reason = [this] { return none_hidden_reason(); }}),
        UserAction{.id = "pieces.isolate",
                   .name = "Isolate Selected",
                   .shortcut = "/",
                   .also = {GLFW_KEY_KP_DIVIDE},
                   .tip = "Hides all other pieces; repeat to show them again.",
                   .run =
                       [this] {
                         workspace_.changes.enqueue({.name = "Isolate pieces",
                                                     .run = [this] { return isolation_.change(), true; },
                                                     .is_one = true});
                       },
                   .disabled_reason = [this] { return isolation_.disabled_reason(); }},
        make_action("pieces.rename", "Rename...", "F2",
                    "Edits the name in the Pieces panel: Enter to confirm, Esc to cancel.",
                    [this] { rename_selected(); }, {.disabled_reason = rename_disabled_reason}),
        make_action(
            "pieces.delete", "Delete Selected", "Del", "Removes the selected pieces from the scene.",
            [this] {
              workspace_.changes.enqueue(
                  {.name = "Delete pieces",
                   .run = [this] { return change_selected([](const PieceId& p) { return DeletePiece{p}; }); },
                   .is_one = true});
            },
            {.disabled_reason = no_emitter_reason}),
    };
  }
  std::vector<UserAction> shown_actions() {
    return {
        UserAction{.id = "pieces.select_one",
                   .name = "Select Pieces",
                   .items = [this] { return pieces_to_select(); }},
        spread_action("pieces.explode_more", "Explode More", kSpreadStep),
        spread_action("pieces.explode_less", "Explode Less", -kSpreadStep),
    };
  }
  std::vector<UserAction> pieces_to_select() {
    std::vector<UserAction> actions;
    PieceMap& looks = workspace_.view.look.pieces;
    for (const PieceRow& row : list_pieces(workspace_.world(), looks)) {
      if (actions.size() >= kMaxNamed) break;
      actions.push_back({.name = row.name, .tip = "Selects only this piece."});
      actions.back().run = [this, &looks, id = row.id] {
        deselect_all(looks);
        looks[id].selected = true;
        workspace_.view.picture_old = true;
      };
      actions.back().disabled_reason = [&looks, id = row.id] {
        const auto look = looks.find(id);
        return look != looks.end() && look->second.hidden ? "This piece is hidden." : nullptr;
      };
    }
    return actions;
  }
  UserAction spread_action(const char* id, const char* name, double by) {
    return picture_action(workspace_.view, id, name,
                          "Draws the pieces apart or closer together, without moving them.", [this, by] {
                            workspace_.view.spread = std::clamp(workspace_.view.spread + by, 0.0, kMaxSpread);
                            spread_pieces(workspace_.world(), workspace_.view.spread, workspace_.view.look);
                          });
  }
  UserAction export_action() {
    return make_action(
        "pieces.export", "Export Selected...", "Ctrl+E",
        "Writes the selected pieces to mesh files, in world space.", [this] { export_.select_file(); },
        {.disabled_reason = [this] { return no_selection_reason(workspace_.view.look.pieces); }});
  }

  void draw_list() {
    list_.draw(workspace_, list_pieces(workspace_.world(), workspace_.view.look.pieces));
    draw_buttons();
    draw_measures(measures_.follow(workspace_.session.document, workspace_.view.look.pieces),
                  workspace_.view.frame.unit);
  }
  void draw_buttons() {
    const char* no_emitter_reason =
        selected_count(workspace_.view.look.pieces) > 0
            ? nullptr
            : "Select a piece first: Ctrl+click it, or click it in the Pieces list.";
    const auto told = [&](const char* meaning, const char* action) {
      return with_shortcut(workspace_.view, meaning, action);
    };
    if (row_button("Hide", 3, no_emitter_reason, told("Hides the selected pieces.", "pieces.hide").c_str()))
      request_hide();
    ImGui::SameLine();
    if (row_button("Show All", 3, none_hidden_reason(),
                   told("Shows all hidden pieces.", "pieces.show_all").c_str()))
      request_show();
    ImGui::SameLine();
    if (row_button("Export", 3, no_emitter_reason,
                   told("Writes the selected pieces to mesh files.", "pieces.export").c_str()))
      export_.select_file();
  }
  void draw_spread(bool one_piece) {
    if (!begin_properties("spread")) return;
    property("Explode");
    double& spread = workspace_.view.spread;
    ImGui::BeginDisabled(one_piece);
    const char* meaning =
        one_piece ? "There is only one piece: cut a piece off first."
                  : "Draws the pieces apart without moving them; a cut or a measurement resets it.";
    if (real_slider({"Explode", "##spread", meaning}, spread, 0, kMaxSpread, "%.2f", {},
                    spread == 0 ? "together" : "")) {
      spread_further(workspace_.world(), spread, workspace_.view.look);
      workspace_.view.picture_old = true;
    }
    ImGui::EndDisabled();
    end_properties();
  }

  // Selects the visible pieces for which the condition holds, and no others.
  void select_if(const std::function<bool(const PieceRow&)>& condition) {
    for (const PieceRow& row : list_pieces(workspace_.world())) {
      PieceLook& look = workspace_.view.look.pieces[row.id];
      look.selected = !look.hidden && condition(row);
    }
    workspace_.view.picture_old = true;
  }
  // Selects the pieces that are like a selected one.
  void select_like(const std::function<bool(const PieceRow&, const PieceRow&)>& alike) {
    std::vector<PieceRow> selected;
    for (const PieceRow& row : list_pieces(workspace_.world())) {
      if (workspace_.view.look.pieces[row.id].selected) selected.push_back(row);
    }
    select_if([&](const PieceRow& row) {
      return std::any_of(selected.begin(), selected.end(),
                         [&](const PieceRow& other) { return alike(row, other); });
    });
  }
  void select_same_material() {
    const auto materials = materials_of_pieces(workspace_.world());
    select_like([&](const PieceRow& a, const PieceRow& b) {
      const auto first = materials.find(a.id), second = materials.find(b.id);
      if (a.id == b.id) return true;
      if (first == materials.end() || second == materials.end()) return false;
      return std::any_of(first->second.begin(), first->second.end(),
                         [&](const std::string& name) { return second->second.contains(name); });
    });
  }
  void frame_selected() {
    Bounds bounds = selected_bounds(workspace_.world(), workspace_.view.look);
    if (bounds.is_none()) bounds = drawn_bounds(workspace_.world(), workspace_.view.look);
    workspace_.view.camera.frame(bounds, workspace_.view.aspect());
  }
  const char* paste_disabled_reason() const {
    const auto is_present = [this](const PieceId& p) { return has_faces(workspace_.world(), p); };
    return std::ranges::any_of(copied_, is_present) ? nullptr : "Nothing to paste: copy a piece first.";
  }
  void request_paste() {
    deselect_all(workspace_.view.look.pieces);
    workspace_.changes.enqueue(
        {.name = "Paste",
         .run = [this, next = size_t(0),
                 newest = std::optional<BodyId>()]() mutable { return paste(next, newest); },
         .is_one = true});
  }
  // Pastes the copied pieces from index `next` on. Returns false if some are left because a change became
  // pending. `newest`: the newest body before the last copy.
  bool paste(size_t& next, std::optional<BodyId>& newest) {
    if (next == 0) follow_world(workspace_.world(), Delta{}, copied_);
    while (!workspace_.changes.is_pending()) {
      select_copy(std::exchange(newest, std::nullopt));
      if (next >= copied_.size()) return true;
      const PieceId piece = copied_[next++];
      newest = workspace_.world().ids().back();
      workspace_.changes.apply(DuplicatePiece{piece, workspace_.world().body(piece.body).placement});
    }
    return false;
  }
  // Selects the pieces of the newest body if it is not the one before the copy.
  void select_copy(const std::optional<BodyId>& before) {
    const std::vector<BodyId> ids = workspace_.world().ids();
    if (!before || ids.empty() || ids.back() == *before) return;
    const Records<Piece>& pieces = workspace_.world().body(ids.back()).pieces;
    for (uint32_t label = 0; label < pieces.size(); ++label) {
      if (pieces[label].faces > 0) workspace_.view.look.pieces[{ids.back(), label}].selected = true;
    }
    workspace_.view.picture_old = true;
  }
  void request_hide() {
    workspace_.changes.enqueue(
        {.name = "Hide pieces",
         .run =
             [this] { return change_selected([](const PieceId& piece) {
                        return HidePiece{piece, true};
                      }); },
         .is_one = true});
  }
  void request_show() {
    workspace_.changes.enqueue(
        {.name = "Show All", .run = [this] { return show_hidden(), true; }, .is_one = true});
  }
  void rename_selected() {
    KERF_ASSERT(selected_count(workspace_.view.look.pieces) == 1);
    workspace_.services.panels.reveal(kPiecesPanel);
    list_.rename(*first_selected(workspace_.view.look.pieces));
  }
  // Changes the pieces one by one, because a command may move a piece to another body. Returns false if some
  // are left because a change became pending.
  bool change_selected(const std::function<Command(const PieceId&)>& command_for) {
    while (const auto piece = first_selected(workspace_.view.look.pieces)) {
      if (workspace_.changes.is_pending()) return false;
      workspace_.view.look.pieces[*piece].selected = false;
      workspace_.changes.apply(command_for(*piece));
    }
    return true;
  }
  // Hidden pieces are separate bodies, so no id changes when one of them is shown.
  void show_hidden() {
    std::vector<Command> commands;
    for (const PieceId& piece : hidden_pieces(workspace_.view.look.pieces))
      commands.emplace_back(HidePiece{piece, false});
    workspace_.changes.change("Show All", is_small(workspace_.session.document),
                              apply_all(std::move(commands)));
  }
  const char* none_hidden_reason() const {
    return hidden_pieces(workspace_.view.look.pieces).empty() ? "No piece is hidden." : nullptr;
  }

  Workspace& workspace_;
  PiecesList list_;
  SelectionMeasures measures_;
  Isolation isolation_{workspace_};
  PieceExport export_{workspace_};
  SelectionShape shape_ = SelectionShape::kBox;
  std::vector<PieceId> copied_;  // for Paste
};

}  // namespace

std::string file_name_of(const std::string& piece) {
  std::string name;
  for (const char c : piece) {
    const auto byte = static_cast<unsigned char>(c);
    const bool usable =
        byte > 0x20 && byte != 0x7f && std::string_view("/\\:*?\"<>|").find(c) == std::string_view::npos;
    name += usable ? c : '-';
  }
  if (!name.empty() && name.front() == '.') name.front() = '-';
  return name.empty() ? "piece" : name;
}

std::vector<PieceFile> files_to_export(const World& world, const PieceMap& looks, const fs::path& file,
                                       bool single_file) {
  const auto format = mesh_format(file.extension().string());
  if (single_file && format && holds_several_meshes(*format)) {
    const fs::path by_name = file.parent_path() / ("*" + file.extension().string());
    std::vector<PieceFile> files = files_to_export(world, looks, by_name);
    for (PieceFile& f : files) f.mesh = file.parent_path() / replaced(file.filename().string(), "pieces");
    return files;
  }
  const size_t selected = selected_count(looks);
  const bool by_name = file.filename().string().find('*') != std::string::npos;
  const bool is_obj = format == MeshFormat::kObj;
  std::vector<PieceFile> files;
  std::set<fs::path> taken;
  for (const PieceRow& row : list_pieces(world, looks)) {
    const auto look = looks.find(row.id);
    if (look == looks.end() || !look->second.selected) continue;
    fs::path mesh = file.parent_path() / replaced(file.filename().string(), file_name_of(row.name));
    if (!by_name && selected > 1) mesh = with_suffix(file, "-" + std::to_string(files.size() + 1));
    const fs::path wanted = mesh;
    for (int i = 2; !taken.insert(mesh).second; ++i) mesh = with_suffix(wanted, "-" + std::to_string(i));
    const Body& body = world.body(row.id.body);
    const bool has_mtl = is_obj && has_materials(body) && !surfaces_of(body);
    files.push_back({row.id, mesh, has_mtl ? fs::path(mesh).replace_extension(".mtl") : fs::path(),
                     mesh.stem().string()});
  }
  return files;
}

Result<ExportedPieces> export_selected(const World& world, const PieceMap& looks,
                                       const std::map<std::string, Paint>& paints, const fs::path& file,
                                       bool single_file) {
  const auto format = mesh_format(file.extension().string());
  if (!format) return bad_input("The file name must end in " + list_mesh_endings());
  std::vector<PieceFile> files = files_to_export(world, looks, file, single_file);
  if (files.empty()) return bad_input("No piece is selected");
  PieceWriter writer(world, paints, *format);
  Status written = writer.write_surfaces(files, file.parent_path());
  if (written) written = writer.write(files);
  if (!written) return written.error();
  return ExportedPieces{std::move(files), writer.note()};
}

std::string unused_name(const World& world, const PieceMap& looks, const fs::path& folder,
                        const std::string& name, bool single_file) {
  const auto exists = [&](const std::string& candidate) {
    const std::vector<PieceFile> files = files_to_export(world, looks, folder / candidate, single_file);
    return std::ranges::any_of(files, [](const PieceFile& f) {
      std::error_code unknown;
      return fs::exists(f.mesh, unknown);
    });
  };
  std::string unused = name;
  for (int i = 2; exists(unused); ++i) unused = with_suffix(name, "-" + std::to_string(i)).string();
  return unused;
}

// Returns the name of the selected piece, or with "*" for several.
std::string PieceExport::suggested_name() const {
  const PieceMap& looks = workspace_.view.look.pieces;
  const std::string ending = "." + std::string(format_row(workspace_.services.browser.format).ending);
  if (selected_count(looks) != 1) return "*" + ending;
  for (const PieceRow& row : list_pieces(workspace_.world(), looks)) {
    if (row.id == first_selected(looks)) return file_name_of(row.name) + ending;
  }
  return "piece" + ending;
}

void PieceExport::select_file() {
  browse(workspace_.services.browser,
         {.title = "Export Selected",
          .verb = "Export",
          .hint = "File name; * stands for the name of each piece",
          .several = selected_count(workspace_.view.look.pieces) > 1,
          .take = [this](const std::filesystem::path& file) { return export_to(file); },
          .writes =
              [this](const std::filesystem::path& file) {
                std::vector<std::filesystem::path> files;
                for (const PieceFile& f : files_to_export(workspace_.world(), workspace_.view.look.pieces,
                                                          file, workspace_.services.browser.single_file)) {
                  if (files.empty() || files.back() != f.mesh) files.push_back(f.mesh);
                  if (!f.mtl.empty()) files.push_back(f.mtl);
                }
                return files;
              },
          .inputs = [this] { return inputs_of(workspace_.session); }},
         workspace_.settings.folder,
         unused_name(workspace_.world(), workspace_.view.look.pieces, workspace_.settings.folder,
                     suggested_name(), workspace_.services.browser.single_file));
}

std::string PieceExport::export_to(const std::filesystem::path& file) {
  const auto written =
      export_selected(workspace_.world(), workspace_.view.look.pieces, workspace_.session.paints, file,
                      workspace_.services.browser.single_file);
  if (!written) return written.error().message;
  const std::string first = written->files.front().mesh.string();
  const std::string count = std::to_string(written->files.size());
  const std::string done = written->files.size() == 1 ? "Exported " + first
                           : written->files.back().mesh == first
                               ? "Exported " + count + " pieces to " + first
                               : "Exported " + count + " pieces; the first is " + first;
  workspace_.message.show(written->note ? done + ". " + *written->note + "." : done,
                          written->note.has_value());
  return "";
}

std::unique_ptr<Feature> pieces_feature(Workspace& workspace) {
  return std::make_unique<PiecesFeature>(workspace);
}

}  // namespace kerf
