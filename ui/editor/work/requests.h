#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "core/document/command.h"
#include "ui/editor/work/preparation.h"

namespace kerf {

// What menus, keys and panels ask for and only the frame loop can do; it is done once, before the next
// picture.
struct Requests {
  std::vector<std::filesystem::path> open;  // in place of what is open, as bodies of one scene
  bool fresh = false;                       // the default scene in place of what is open
  bool quit = false;
  bool play = false;              // the game, until the player comes back
  std::filesystem::path save_to;  // empty: nowhere
  bool recut = false;             // at the resolution that is set now
  bool recut_radius = false;      // with the radius that is set now, too
  bool undo = false, redo = false;
  bool stop = false;  // what the beam is at
  bool hide_chosen = false, show_hidden = false, isolate = false, delete_chosen = false;
  bool duplicate_chosen = false;
  std::optional<bool> pin_chosen;          // pin, or let move again
  std::optional<Sheet> sheet;              // of the chosen pieces, or of all if none is chosen
  std::optional<Preparation> preparation;  // of the chosen pieces, or of all if none is chosen
  std::vector<Command> commands;
  std::filesystem::path save_path_to;  // the path of the laser; empty: nowhere
  bool run_path = false;
  std::optional<size_t> travel;  // to a position of the history
  enum class Screenshot { kNone, kPicture, kWindow };
  Screenshot screenshot = Screenshot::kNone;

  // Whether what is open would be closed.
  bool leaves_work() const { return !open.empty() || fresh || quit; }
};

}  // namespace kerf
