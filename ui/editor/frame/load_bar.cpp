#include "ui/editor/frame/load_bar.h"

#include "ui/window/progress_bar.h"

namespace kerf {

void draw_load_bar(const Area& picture, Opening& opening, Message& message) {
  const FileLoader& loader = opening.loader;
  if (!loader.busy()) return;
  if (draw_progress(picture, "Opening " + loader.order().name(), loader.fraction(), true))
    cancel_opening(opening, message);
}

}  // namespace kerf
