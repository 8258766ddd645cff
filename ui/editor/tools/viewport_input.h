#pragma once

#include "ui/editor/path/placed_lasers.h"
#include "ui/editor/play/play_state.h"
#include "ui/editor/tools/hand.h"
#include "ui/editor/view/settings.h"
#include "ui/editor/view/view_state.h"
#include "ui/editor/work/file_loader.h"
#include "ui/editor/work/open_work.h"
#include "ui/editor/work/requests.h"
#include "ui/window/message.h"
#include "ui/window/window.h"

namespace kerf {

// What the mouse works on in the picture.
struct MouseParts {
  Hand& hand;
  OpenWork& work;
  ViewState& view;
  const Settings& settings;
  const FileLoader& loader;
  Requests& requests;
  Message& message;
  PlacedLasers& lasers;
  const PlayState& play;
};

// What the mouse does in the picture: left drag cuts or, with the tool that picks or Ctrl held, a click
// chooses the piece there and a drag those in a box, or while bodies move pulls the piece there; with the
// path in hand it adds and drags points; middle or Alt+left drag orbits, Shift+middle or right drag pans, the
// wheel zooms to the pointer. A drag belongs to where it began and goes on across panels. `free` says that no
// panel or menu wants the mouse.
void handle_mouse(const MouseParts& on, const InputEvent& event, bool free);

}  // namespace kerf
