#include "ui/editor/actions.h"
#include "ui/editor/prepare/prepare_panel.h"

namespace kerf {

namespace {

// Unfolds the panel with this tool.
UserAction tool_action(EditorState& s, const char* name, const char* tip, Preparation::Tool tool, bool last) {
  return {.menu = "Prepare",
          .name = name,
          .tip = tip,
          .run =
              [&s, tool] {
                s.settings.side_shown = s.settings.panels[PanelId::kPrepare] = true;
                s.preparation.tool = tool;
                s.preparation.times = 1;
              },
          .checked = [&s, tool] { return s.settings.shows(PanelId::kPrepare) && s.preparation.tool == tool; },
          .ends_group = last};
}

Preparation wanted(const EditorState& s) {
  const World& world = s.work.document.world();
  return with_numbers(s.preparation, pieces_to_prepare(world, s.view.look.pieces), world);
}

}  // namespace

std::vector<UserAction> prepare_actions(EditorState& s) {
  using Kind = Preparation::Tool;
  return {
      tool_action(s, "Simplify to faces", "Fewer faces: the panel Prepare says how many.",
                  Kind::kSimplifyToFaces, false),
      tool_action(s, "Simplify to an error", "As few faces as an error in the unit of the file allows.",
                  Kind::kSimplifyToError, false),
      tool_action(s, "Subdivide", "Three or four faces of each, rounder or where they are.", Kind::kSubdivide,
                  false),
      tool_action(s, "Smooth", "Vertices move to the middle of their neighbours.", Kind::kSmooth, true),
      UserAction{.menu = "Prepare",
                 .name = "Prepare the mesh",
                 .tip = "Does what the panel Prepare says, to the chosen pieces, or to all.",
                 .run = [&s] { s.requests.preparation = wanted(s); },
                 .why_not =
                     [&s] {
                       return why_no_preparation(
                           pieces_to_prepare(s.work.document.world(), s.view.look.pieces), wanted(s));
                     }},
  };
}

}  // namespace kerf
