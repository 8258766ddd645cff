#pragma once

#include <map>
#include <optional>
#include <string>

#include "core/base/result.h"
#include "core/document/scene.h"
#include "ui/editor/shared/piece_set.h"
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

// The text of a view for the clipboard: {"eye":[x,y,z],"target":[x,y,z]}, like the "view" of a scene file.
std::string view_text(const View& view);

// Parses that text, or a whole scene that has a "view".
Result<View> parse_view_text(const std::string& text);

// The first half of the picture, which shows the open document, with its camera: where points of the world
// are in the window (screen coordinates), and which rays belong to places of the window.
class FirstPicture {
 public:
  explicit FirstPicture(const ViewState& view)
      : camera_(view.seen_first()), area_(view.layout.first), em_(view.layout.em) {}

  const CameraView& camera() const { return camera_; }
  double em() const { return em_; }  // the size of the text

  // The place of a point of the world; nothing behind the eye.
  std::optional<Vec2> place_of(const Vec3& p) const;
  // The length (m) that is as long as the text is high, at the depth of a point in front of the eye.
  double metres_of_em(const Vec3& p) const;
  // The ray through a place. Its direction is a unit vector.
  Pose ray(Vec2 place) const;
  // The point on that ray at the depth of a point of the world.
  Vec3 at_depth_of(const Vec3& p, Vec2 place) const;

 private:
  CameraView camera_;
  Area area_;
  double em_;
};

// The badges of modes that are on, below each other at the upper edge of the first half of the viewport.
class Badges {
 public:
  enum class Sign { kPlaying, kPaused, kMode };

  // To be called once a frame before any is drawn.
  void begin_frame() { drawn_ = 0; }
  // Draws the next one, `least_ems` wide at least, so that it does not change its width with its text. The
  // landmark is its name in tests.
  void draw(const ViewState& view, Sign sign, const std::string& text, const char* landmark,
            float least_ems = 0);

 private:
  int drawn_ = 0;
};

}  // namespace kerf
