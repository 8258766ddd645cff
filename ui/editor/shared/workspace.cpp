#include "ui/editor/shared/workspace.h"

#include <algorithm>

#include "ui/render/view/view_options.h"

namespace kerf {

Workspace::Workspace() = default;

const char* Workspace::why_time_stands_still() const {
  if (opening.loader.busy()) return "A file is being opened.";
  for (const auto& why_not : time_holds) {
    if (const char* why = why_not()) return why;
  }
  return world().live_faces() == 0 ? "There is nothing that could move." : nullptr;
}

std::vector<std::filesystem::path> Workspace::not_taken(std::vector<std::filesystem::path> files) const {
  std::erase_if(files, [this](const std::filesystem::path& file) {
    return std::any_of(file_takers.begin(), file_takers.end(),
                       [&](const auto& takes) { return takes(file); });
  });
  return files;
}

bool cancel_stroke(Workspace& on) {
  if (!on.beam.cutting()) return false;
  if (on.beam.release(on.work.document)) on.message.say("Missed: the beam met nothing.");
  return true;
}

void stand_together(Workspace& on) {
  if (on.view.spread == 0) return;
  on.view.spread = 0;
  spread_pieces(on.world(), 0, on.view.look);
}

UserAction tool_action(Workspace& on, const char* name, const char* shortcut, const char* tip,
                       bool has_panel) {
  return {.name = name,
          .shortcut = shortcut,
          .tip = tip,
          .run =
              [&on, name, has_panel] {
                if (on.held && on.held->cuts()) cancel_stroke(on);
                on.tool = name;
                if (has_panel) on.panels.show(name);
              },
          .checked = [&on, name] { return on.tool == name; }};
}

UserAction picture_action(ViewState& view, const char* name, const char* tip, std::function<void()> change) {
  return {.name = name,
          .tip = tip,
          .run = [&view, change = std::move(change)] { change(), view.picture_old = true; },
          .in_menu = false};
}

UserAction flag_action(ViewState& view, const char* name, bool& flag, const char* tip) {
  UserAction action = picture_action(view, name, tip, [&flag] { flag = !flag; });
  action.checked = [&flag] { return flag; };
  return action;
}

}  // namespace kerf
