#include "core/base/assert.h"
#include "ui/editor/actions.h"
#include "ui/editor/view/file_frames.h"
#include "ui/editor/view/light_presets.h"
#include "ui/editor/view/piece_set.h"
#include "ui/render/spread.h"

namespace kerf {

namespace {

constexpr double kSpreadStep = 0.25, kMostSpread = 1.5;
constexpr size_t kMostNamed = 100;  // pieces

// A flag of the picture.
UserAction flag_action(EditorState& s, const char* menu, const char* name, bool& flag, const char* tip) {
  return {.menu = menu,
          .name = name,
          .tip = tip,
          .run = [&s, &flag] { flag = !flag, s.view.picture_old = true; },
          .checked = [&flag] { return flag; },
          .in_menu = false};
}

std::vector<UserAction> presets(EditorState& s) {
  std::vector<UserAction> actions;
  for (const LightPreset& preset : light_presets()) {
    actions.push_back({.menu = "Light", .name = preset.name, .tip = preset.meaning});
    actions.back().run = [&s, &preset] {
      ViewOptions& look = s.view.look;
      look.lights = lights_of(preset, s.work.document.world().bounds(), s.view.camera.up_axis());
      look.shadow.inspected = 0;
      s.view.picture_old = true;
    };
  }
  return actions;
}

std::vector<UserAction> pieces_to_choose(EditorState& s) {
  std::vector<UserAction> actions;
  const PieceMap& looks = s.view.look.pieces;
  for (const PieceRow& row : list_pieces(s.work.document.world(), looks)) {
    if (actions.size() >= kMostNamed) break;
    actions.push_back({.menu = "Pieces", .name = row.name, .tip = "Chooses this piece, and no other."});
    actions.back().run = [&s, id = row.id] {
      choose_none(s.view.look.pieces);
      s.view.look.pieces[id].selected = true;
      s.view.picture_old = true;
    };
    actions.back().why_not = [&looks, id = row.id] {
      const auto look = looks.find(id);
      return look != looks.end() && look->second.hidden ? "It is hidden." : nullptr;
    };
  }
  return actions;
}

UserAction spread_action(EditorState& s, const char* name, double by) {
  return {.menu = "Pieces",
          .name = name,
          .tip = "Draws the pieces away from the middle, or back. They stay where they are.",
          .run =
              [&s, by] {
                s.view.spread = std::clamp(s.view.spread + by, 0.0, kMostSpread);
                spread_pieces(s.work.document.world(), s.view.spread, s.view.look);
                s.view.picture_old = true;
              },
          .in_menu = false};
}

UserAction frame_action(EditorState& s, const std::string& name, const FileFrame& frame, const char* tip) {
  return {.menu = "File",
          .name = name,
          .tip = tip,
          .run = [&s, frame] { set_frame(frame, s.work.scene, s.view, s.settings); },
          .in_menu = false};
}

// The frame is that of the moment at which they are listed.
std::vector<UserAction> frames(EditorState& s) {
  std::vector<UserAction> actions;
  for (const FileUnit unit :
       {FileUnit::kMillimetre, FileUnit::kCentimetre, FileUnit::kMetre, FileUnit::kInch}) {
    actions.push_back(frame_action(s, "unit " + std::string(unit_symbol(unit)), {unit, s.view.frame.up},
                                   "What one unit of the file is."));
  }
  for (const UpAxis up : {UpAxis::kY, UpAxis::kZ}) {
    actions.push_back(frame_action(s, up == UpAxis::kY ? "+Y upwards" : "+Z upwards", {s.view.frame.unit, up},
                                   "Which axis of the file points upwards."));
  }
  return actions;
}

UserAction level_action(EditorState& s, const char* name, int by) {
  return {.menu = "Tree",
          .name = name,
          .tip = "Levels of the tree under its root that are drawn.",
          .run =
              [&s, by] {
                const int all = std::max(1, s.figures.shown.tree_depth.value_or(1));
                int& deepest = s.view.look.tree.deepest;
                deepest = std::max(0, std::min(deepest, all) + by);
                s.view.picture_old = true;
              },
          .why_not = [&s] { return s.view.look.show.aabb ? nullptr : "The boxes are not shown."; },
          .in_menu = false};
}

}  // namespace

std::vector<UserAction> light_actions(EditorState& s) {
  ViewOptions& look = s.view.look;
  return {
      UserAction{
          .menu = "Light", .name = "Light preset", .items = [&s] { return presets(s); }, .in_menu = false},
      UserAction{.menu = "Light",
                 .name = "Add a light",
                 .tip = "A directional light; its handle is dragged while the Light panel is open.",
                 .run = [&s] { add_light(s.view.look, s.view.camera.up_axis()), s.view.picture_old = true; },
                 .why_not =
                     [&look] {
                       return look.lights.size() < kMostLights ? nullptr : "There are four lights already.";
                     },
                 .in_menu = false},
      UserAction{.menu = "Light",
                 .name = "Remove the chosen light",
                 .tip = "The one that the Light panel shows.",
                 .run = [&s] { remove_light(s.view.look), s.view.picture_old = true; },
                 .why_not = [&look] { return look.lights.empty() ? "There is no light." : nullptr; },
                 .in_menu = false},
      UserAction{.menu = "Light",
                 .name = "Next light",
                 .tip = "Chooses the light whose values the Light panel shows.",
                 .run =
                     [&s, &look] {
                       KERF_ASSERT(!look.lights.empty());
                       look.shadow.inspected = (look.shadow.inspected + 1) % look.lights.size();
                       s.view.picture_old = true;
                     },
                 .why_not = [&look] { return look.lights.size() < 2 ? "There is no other light." : nullptr; },
                 .in_menu = false},
      flag_action(s, "Light", "Shadows: paper look", look.shadow.paper_look,
                  "Transparent black over what is in shadow, in place of leaving the light out."),
  };
}

std::vector<UserAction> shown_actions(EditorState& s) {
  TreeOverlay& tree = s.view.look.tree;
  return {
      UserAction{.menu = "Pieces",
                 .name = "Choose",
                 .items = [&s] { return pieces_to_choose(s); },
                 .in_menu = false},
      spread_action(s, "Pieces further apart", kSpreadStep),
      spread_action(s, "Pieces nearer together", -kSpreadStep),
      UserAction{.menu = "File", .name = "Shown in", .items = [&s] { return frames(s); }, .in_menu = false},
      flag_action(s, "Tree", "Boxes: leaves only", tree.leaves_only, "Only the boxes that hold one face."),
      flag_action(s, "Tree", "Boxes: only where the beam was", tree.hit_only,
                  "Only the boxes in which the beam is or was."),
      level_action(s, "Boxes: one level more", 1),
      level_action(s, "Boxes: one level less", -1),
      UserAction{.menu = "Tree",
                 .name = "Boxes: orange and blue",
                 .tip = "Colours that can be told apart by the colour-blind, in place of red and green.",
                 .run =
                     [&s] {
                       BoxPalette& palette = s.settings.palette;
                       palette = palette == BoxPalette::kRedAndGreen ? BoxPalette::kOrangeAndBlue
                                                                     : BoxPalette::kRedAndGreen;
                       s.view.picture_old = true;
                     },
                 .checked = [&s] { return s.settings.palette == BoxPalette::kOrangeAndBlue; },
                 .in_menu = false},
  };
}

}  // namespace kerf
