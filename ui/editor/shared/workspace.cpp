#include "ui/editor/shared/workspace.h"

#include <algorithm>

#include "ui/render/view/view_options.h"

namespace kerf {

const char* Workspace::time_disabled_reason() const {
  if (opening.loader.busy()) return "A file is being opened.";
  for (const auto& disabled_reason : links.time_holds) {
    if (const char* why = disabled_reason()) return why;
  }
  return world().live_faces() == 0 ? "The scene is empty: open a file, or undo." : nullptr;
}

std::vector<std::filesystem::path> FeatureLinks::extract_accepted(
    std::vector<std::filesystem::path>& files) const {
  const auto accepted = std::stable_partition(files.begin(), files.end(), [this](const auto& file) {
    return std::ranges::none_of(file_takers, [&](const FileTaker& taker) { return taker.accepts(file); });
  });
  std::vector<std::filesystem::path> extracted(accepted, files.end());
  files.erase(accepted, files.end());
  return extracted;
}

void FeatureLinks::take(const std::vector<std::filesystem::path>& files) const {
  for (const std::filesystem::path& file : files) {
    const auto taker = std::ranges::find_if(file_takers, [&](const FileTaker& t) { return t.accepts(file); });
    if (taker != file_takers.end()) taker->take(file);
  }
}

bool cancel_stroke(Workspace& workspace) {
  if (!workspace.beam.cutting()) return false;
  if (workspace.beam.release(workspace.session.document))
    workspace.message.info("Missed: the beam hit nothing.");
  return true;
}

bool end_exploded_view(const World& world, ViewState& view) {
  if (view.spread == 0) return false;
  view.spread = 0;
  spread_pieces(world, 0, view.look);
  view.picture_old = true;
  return true;
}

UserAction tool_action(Workspace& workspace, const char* tool, const char* name, const char* shortcut,
                       const char* tip, bool has_panel) {
  return {.id = std::string("tool.") + tool,
          .name = name,
          .shortcut = shortcut,
          .tip = tip,
          .run =
              [&workspace, tool, has_panel] {
                if (workspace.input.held && workspace.input.held->cuts()) cancel_stroke(workspace);
                workspace.input.tool = tool;
                if (has_panel) workspace.services.panels.show(tool);
              },
          .checked = [&workspace, tool] { return workspace.input.tool == tool; }};
}

UserAction picture_action(ViewState& view, const char* id, const char* name, const char* tip,
                          std::function<void()> change) {
  return {.id = id, .name = name, .tip = tip, .run = [&view, change = std::move(change)] {
            change(), view.picture_old = true;
          }};
}

UserAction flag_action(ViewState& view, const char* id, const char* name, bool& flag, const char* tip) {
  UserAction action = picture_action(view, id, name, tip, [&flag] { flag = !flag; });
  action.checked = [&flag] { return flag; };
  return action;
}

}  // namespace kerf
