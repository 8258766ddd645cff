#include "ui/editor/shared/features.h"

#include <imgui.h>

#include <GLFW/glfw3.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/base/assert.h"
#include "ui/editor/pieces/piece_export.h"
#include "ui/editor/pieces/piece_selection.h"
#include "ui/editor/pieces/pieces_list.h"
#include "ui/editor/shared/panel_rows.h"
#include "ui/editor/shared/piece_set.h"
#include "ui/editor/shared/viewport_pointer.h"
#include "ui/editor/shared/world_changes.h"
#include "ui/render/view/view_options.h"
#include "ui/window/property_rows.h"
#include "ui/window/widgets.h"

namespace kerf {

namespace {

constexpr double kSpreadStep = 0.25, kMostSpread = 1.5;
constexpr size_t kMostNamed = 100;  // pieces
constexpr const char* kPiecesPanel = "Pieces";

class PiecesFeature : public Feature {
 public:
  explicit PiecesFeature(Workspace& on) : on_(on) {}

  std::vector<Panel> panels() override {
    return {
        {kPiecesPanel, Tab::kCut, 600, true, [this] { draw_list(); }},
        {kPiecesPanel, Tab::kCut, 602, true, [this] { draw_spread(list_pieces(on_.world()).size() < 2); }}};
  }
  std::vector<ActionGroup> actions() override {
    return {
        {120, "File", {export_action()}},
        {230, "Edit", piece_actions()},
        {301,
         "Tool",
         {tool_action(on_, kPickTool, "K",
                      "A click chooses a piece, a drag the pieces in a box; with Shift they are added. With "
                      "the laser in hand, Ctrl does the same.")}},
        {1400, "Pieces", shown_actions()}};
  }
  std::vector<Gesture> gestures() const override {
    return {{20, "Ctrl+click", "Choose a piece; with Shift one more"},
            {30, "Ctrl+left drag", "Choose the pieces in a box; from right to left those that it touches"},
            {90, "Double click on a name in the list", "Rename the piece"}};
  }

  std::unique_ptr<Interaction> claim(const Press& press) override {
    return picks(on_, press) ? press_on_pieces(on_) : nullptr;
  }
  bool let_go() override {
    const bool any = chosen_pieces(on_.view.look.pieces) > 0;
    choose_none(on_.view.look.pieces);
    on_.view.picture_old = on_.view.picture_old || any;
    return any;
  }
  const char* hint() const override {
    return on_.tool == kPickTool
               ? "Pick: click or drag a box, Shift adds; G moves the chosen piece, R turns it"
               : nullptr;
  }

  bool awaits_focus() const override { return list_.awaits_focus(); }
  void draw_windows() override { list_.end_hidden_edit(on_); }

  void follow(const Delta&) override { isolation_.follow(); }
  void forget() override {
    on_.view.look.pieces.clear();
    on_.view.numbers = PieceNumbers();
    on_.view.spread = 0;
    isolation_.forget();
    list_.forget_rename();
  }
  void report(nlohmann::ordered_json& report) const override {
    report["pieces_chosen"] = chosen_pieces(on_.view.look.pieces);
    report["pieces_hidden"] = hidden_pieces(on_.view.look.pieces).size();
    report["spread"] = on_.view.spread;
  }

 private:
  std::vector<UserAction> piece_actions();
  std::vector<UserAction> shown_actions();
  std::vector<UserAction> pieces_to_choose();
  UserAction spread_action(const char* name, double by);
  UserAction export_action();

  void draw_list();
  void draw_buttons();
  void draw_spread(bool one_piece);

  void choose_all();
  void ask_to_hide();
  void ask_to_show();
  void rename_chosen();
  bool change_chosen(const std::function<Command(const PieceId&)>& command_for);
  void show_hidden();
  const char* why_none_hidden() const {
    return hidden_pieces(on_.view.look.pieces).empty() ? "No piece is hidden." : nullptr;
  }

  Workspace& on_;
  PiecesList list_;
  Isolation isolation_{on_};
  PieceExport export_{on_};
};

// Actions
// --------------------------------------------------------------------------------------------------------

std::vector<UserAction> PiecesFeature::piece_actions() {
  const auto why_none = [this] { return why_none_chosen(on_.view.look.pieces); };
  const auto why_no_rename = [this]() -> const char* {
    if (const char* why = why_none_chosen(on_.view.look.pieces)) return why;
    return chosen_pieces(on_.view.look.pieces) > 1
               ? "Several pieces are chosen: choose one alone to rename it."
               : nullptr;
  };
  return {
      UserAction{.name = "Choose all pieces",
                 .shortcut = "Ctrl+A",
                 .tip = "All that are not hidden.",
                 .run = [this] { choose_all(); }},
      UserAction{.name = "Hide the chosen",
                 .shortcut = "H",
                 .tip = "Leaves the chosen pieces out of the picture; the beam passes them by.",
                 .run = [this] { ask_to_hide(); },
                 .why_not = why_none},
      UserAction{.name = "Show all pieces",
                 .shortcut = "Shift+H",
                 .tip = "Draws the hidden pieces again.",
                 .run = [this] { ask_to_show(); },
                 .why_not = [this] { return why_none_hidden(); }},
      UserAction{.name = "Isolate the chosen",
                 .shortcut = "/",
                 .pad_key = GLFW_KEY_KP_DIVIDE,
                 .tip = "Hides all other pieces; the same again shows them as they were.",
                 .run =
                     [this] {
                       on_.changes.ask({.name = "Isolate pieces",
                                        .run = [this] { return isolation_.change(), true; },
                                        .is_one = true});
                     },
                 .why_not = [this] { return isolation_.why_not(); }},
      UserAction{
          .name = "Rename the chosen",
          .shortcut = "F2",
          .tip = "Edits the name of the chosen piece in the Pieces panel: Enter takes it, Esc does not.",
          .run = [this] { rename_chosen(); },
          .why_not = why_no_rename},
      UserAction{
          .name = "Delete the chosen",
          .shortcut = "Del",
          .tip = "Takes the chosen pieces out of the world.",
          .run =
              [this] {
                on_.changes.ask(
                    {.name = "Delete pieces",
                     .run = [this] { return change_chosen([](const PieceId& p) { return DeletePiece{p}; }); },
                     .is_one = true});
              },
          .why_not = why_none,
          .ends_group = true},
  };
}

UserAction PiecesFeature::export_action() {
  return {.name = "Export chosen pieces...",
          .shortcut = "Ctrl+E",
          .tip = "As meshes, where they stand; several go to numbered files.",
          .run = [this] { export_.choose_file(); },
          .why_not = [this] { return why_none_chosen(on_.view.look.pieces); }};
}

std::vector<UserAction> PiecesFeature::pieces_to_choose() {
  std::vector<UserAction> actions;
  PieceMap& looks = on_.view.look.pieces;
  for (const PieceRow& row : list_pieces(on_.world(), looks)) {
    if (actions.size() >= kMostNamed) break;
    actions.push_back({.name = row.name, .tip = "Chooses this piece, and no other."});
    actions.back().run = [this, &looks, id = row.id] {
      choose_none(looks);
      looks[id].selected = true;
      on_.view.picture_old = true;
    };
    actions.back().why_not = [&looks, id = row.id] {
      const auto look = looks.find(id);
      return look != looks.end() && look->second.hidden ? "It is hidden." : nullptr;
    };
  }
  return actions;
}

UserAction PiecesFeature::spread_action(const char* name, double by) {
  return picture_action(on_.view, name,
                        "Draws the pieces away from the middle, or back. They stay where they are.",
                        [this, by] {
                          on_.view.spread = std::clamp(on_.view.spread + by, 0.0, kMostSpread);
                          spread_pieces(on_.world(), on_.view.spread, on_.view.look);
                        });
}

std::vector<UserAction> PiecesFeature::shown_actions() {
  return {
      UserAction{.name = "Choose", .items = [this] { return pieces_to_choose(); }, .in_menu = false},
      spread_action("Pieces further apart", kSpreadStep),
      spread_action("Pieces nearer together", -kSpreadStep),
  };
}

// The panel
// --------------------------------------------------------------------------------------------------------

void PiecesFeature::draw_list() {
  list_.draw(on_, list_pieces(on_.world(), on_.view.look.pieces), [this] { ask_to_hide(); });
  draw_buttons();
}

void PiecesFeature::draw_buttons() {
  const char* why_none = chosen_pieces(on_.view.look.pieces) > 0
                             ? nullptr
                             : "No piece is chosen: Ctrl+click one in the picture, or click it in the list.";
  const auto told = [&](const char* meaning, const char* action) {
    return with_shortcut(on_.view, meaning, action);
  };
  if (row_button("Hide", 3, why_none,
                 told("Leaves the chosen pieces out of the picture.", "Hide the chosen").c_str()))
    ask_to_hide();
  ImGui::SameLine();
  if (row_button("Show all", 3, why_none_hidden(),
                 told("Draws the hidden pieces again.", "Show all pieces").c_str()))
    ask_to_show();
  ImGui::SameLine();
  if (row_button("Export", 3, why_none,
                 told("Writes the chosen pieces to mesh files.", "Export chosen pieces...").c_str()))
    export_.choose_file();
}

void PiecesFeature::draw_spread(bool one_piece) {
  if (!begin_properties("spread")) return;
  property("Spread");
  double& spread = on_.view.spread;
  ImGui::BeginDisabled(one_piece);
  const char* meaning = one_piece ? "There is only one piece: cut something off first."
                                  : "Draws the pieces apart, away from the middle. They stay where they are: "
                                    "the next cut draws them together again.";
  if (real_slider({"Spread", "##spread", meaning}, spread, 0, kMostSpread, "%.2f", {},
                  spread == 0 ? "together" : "")) {
    spread_further(on_.world(), spread, on_.view.look);
    on_.view.picture_old = true;
  }
  ImGui::EndDisabled();
  end_properties();
}

// Changes
// --------------------------------------------------------------------------------------------------------

void PiecesFeature::choose_all() {
  for (const PieceRow& row : list_pieces(on_.world())) {
    PieceLook& look = on_.view.look.pieces[row.id];
    look.selected = !look.hidden;
  }
  on_.view.picture_old = true;
}

void PiecesFeature::ask_to_hide() {
  on_.changes.ask(
      {.name = "Hide pieces",
       .run = [this] { return change_chosen([](const PieceId& piece) {
                         return HidePiece{piece, true};
                       }); },
       .is_one = true});
}

void PiecesFeature::ask_to_show() {
  on_.changes.ask({.name = "Show all pieces", .run = [this] { return show_hidden(), true; }, .is_one = true});
}

void PiecesFeature::rename_chosen() {
  KERF_ASSERT(chosen_pieces(on_.view.look.pieces) == 1);
  on_.panels.reveal(kPiecesPanel);
  list_.rename(*first_chosen(on_.view.look.pieces));
}

// One after the other, because a piece may be part of another body after a command. Returns false where some
// are left because one became pending.
bool PiecesFeature::change_chosen(const std::function<Command(const PieceId&)>& command_for) {
  while (const auto piece = first_chosen(on_.view.look.pieces)) {
    if (on_.changes.is_pending()) return false;
    on_.view.look.pieces[*piece].selected = false;
    on_.changes.apply(command_for(*piece));
  }
  return true;
}

// Hidden pieces are bodies of their own, so that no id changes when one of them is shown.
void PiecesFeature::show_hidden() {
  std::vector<Command> commands;
  for (const PieceId& piece : hidden_pieces(on_.view.look.pieces))
    commands.emplace_back(HidePiece{piece, false});
  on_.changes.change("Show all pieces", is_small(on_.work.document), apply_all(std::move(commands)));
}

}  // namespace

std::unique_ptr<Feature> pieces_feature(Workspace& on) { return std::make_unique<PiecesFeature>(on); }

}  // namespace kerf
