#pragma once

#include <map>
#include <optional>
#include <string>

#include "core/document/files/scene.h"
#include "ui/editor/shared/pieces/piece_numbers.h"
#include "ui/render/view/camera.h"
#include "ui/render/view/view_options.h"
#include "ui/window/layout.h"

namespace kerf {

// The view of the open world, and the area of its picture in the window.
struct ViewState {
  Camera camera;
  ViewOptions look;
  PieceNumbers numbers;         // of the pieces, which `look` shows
  FileFrame frame;              // in which the world is shown; its upward axis is that of the camera
  std::string frame_asked_for;  // the kind of file about whose frame the user is asked; empty: no question
  std::optional<View> home;     // the view that the scene asks for
  double spread = 0;  // displacement of pieces, as a multiple of their distance from the centre of the world
  Layout layout;
  Area legends;  // the part of the picture that legends cover
  std::map<std::string, std::string>
      shortcuts;            // keys by the names of actions, as they are bound at the moment
  bool in_second = false;   // the pointer is in the right half of a split picture, or its drag began there
  bool picture_old = true;  // the picture has to be redrawn
  bool heat_old = false;    // the temperatures in it have to be, because something has cooled down

  // The half of the picture under the pointer, or all of it if it is not split.
  const Area& pane() const { return in_second ? layout.second : layout.first; }
  double aspect() const { return pane().size.x / pane().size.y; }
  // The camera with the proportions of that half.
  CameraView seen() const { return camera.view(aspect()); }
  // The camera with those of the first half, which alone shows the open document.
  CameraView seen_first() const { return camera.view(layout.first.size.x / layout.first.size.y); }
  // A place of the window (screen coordinates) as CameraView::ray takes it, in the pointer's half or in the
  // first.
  Vec2 in_picture(Vec2 at) const;
  Vec2 in_first(Vec2 at) const;
};

// Looks at a world of these bounds from where the scene asks to, or from three-quarter in front.
void go_home(ViewState& view, const World::Bounds& bounds);

}  // namespace kerf
