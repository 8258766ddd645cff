#include "ui/editor/actions.h"
#include "ui/editor/section/section_edits.h"

namespace kerf {

namespace {

using Edit = std::function<void(ViewState&)>;

// The plane is shown first, where it is not.
UserAction edit_action(EditorState& s, const char* name, const char* tip, Edit edit) {
  UserAction action{.menu = "View", .name = name, .tip = tip, .in_menu = false};
  action.run = [&s, edit = std::move(edit)] {
    s.view.look.show.section = true;
    place_section(s.view, s.work.document.world());
    if (s.view.look.section) edit(s.view);
  };
  return action;
}

UserAction across(EditorState& s, const char* name, int axis) {
  return edit_action(s, name, "Turns the section plane about its point; what is towards the eye goes.",
                     [axis](ViewState& view) { turn_section_across(view, axis); });
}

}  // namespace

std::vector<UserAction> section_actions(EditorState& s) {
  return {
      edit_action(s, "Section plane: flip", "Shows the other side.", flip_section),
      across(s, "Section plane: across X", 0),
      across(s, "Section plane: across Y", 1),
      across(s, "Section plane: across Z", 2),
      edit_action(s, "Section plane: parallel to the picture", "Turns it about its point.",
                  turn_section_to_view),
      edit_action(s, "Section plane: copy", "As text, as kerf render --section takes it.",
                  [&s](ViewState& view) { copy_section(view, s.message); }),
      UserAction{.menu = "View",
                 .name = "Section plane: paste",
                 .tip = "Sets it as the text in the clipboard says.",
                 .run = [&s] { paste_section(s.view, s.message); },
                 .in_menu = false},
  };
}

}  // namespace kerf
