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

// The view of the open document, and its area in the window.
struct ViewState {
  Camera camera;
  ViewOptions look;
  PieceNumbers numbers;         // of the pieces in `look`
  FileFrame frame;              // in which the world is shown; its up axis is the camera's
  std::string frame_asked_for;  // mesh format whose frame the user is asked about; empty: none
  std::optional<View> home;     // initial view, from the scene
  double spread = 0;            // displacement of pieces over their distance from the centre of the world
  Layout layout;
  Area header, toolbar;  // the parts that the options of the tool and the tools cover; may be empty
  Area legends;          // the part of the viewport that legends cover
  std::map<std::string, std::string> shortcuts;  // bound chords by action
  const World* second_world = nullptr;           // in the right half of a split view; null: not split
  bool in_second = false;   // the pointer is in the right half of a split view, or its drag began there
  bool picture_old = true;  // the viewport needs a redraw
  bool heat_old = false;    // the temperatures in the viewport need a redraw, after cooling

  // The half of the viewport under the pointer, or all of it if it is not split.
  const Area& pane() const { return in_second ? layout.second : layout.first; }
  // The first half without the line of the header.
  Area below_header() const {
    const Vec2 covered(0, header.size.y);
    return {layout.first.at + covered, layout.first.size - covered};
  }
  double aspect() const { return pane().size.x / pane().size.y; }
  // The camera with the aspect ratio of that half.
  CameraView seen() const { return camera.view(aspect()); }
  // The camera with the aspect ratio of the first half, which alone shows the open document.
  CameraView seen_first() const { return camera.view(layout.first.size.x / layout.first.size.y); }
  // Convert screen coordinates to those of CameraView::ray, in the pointer's half or in the first.
  Vec2 in_picture(Vec2 at) const;
  Vec2 in_first(Vec2 at) const;
};

// Moves the camera to the scene's own view, or to a three-quarter view of these bounds.
void go_home(ViewState& view, const World::Bounds& bounds);

// Formats a view for the clipboard: {"eye":[x,y,z],"target":[x,y,z]}, like the "view" of a scene file.
std::string view_text(const View& view);

// Parses that text, or a whole scene that has a "view".
Result<View> parse_view_text(const std::string& text);

// The projection of the first half of the viewport, which shows the open document, between points of the
// world and places of the window (screen coordinates).
class PrimaryViewport {
 public:
  explicit PrimaryViewport(const ViewState& view)
      : camera_(view.seen_first()), area_(view.layout.first), em_(view.layout.em) {}

  const CameraView& camera() const { return camera_; }
  double em() const { return em_; }  // size of the text

  // Projects a point of the world; nullopt if it lies behind the eye.
  std::optional<Vec2> place_of(const Vec3& p) const;
  // Returns the length [m] of a text size (em) at the depth of a point in front of the eye.
  double metres_of_em(const Vec3& p) const;
  // Returns the ray through a place, with a unit direction.
  Pose ray(Vec2 place) const;
  // Returns the point on that ray at the depth of a point of the world.
  Vec3 at_depth_of(const Vec3& p, Vec2 place) const;

 private:
  CameraView camera_;
  Area area_;
  double em_;
};

// Badges of active modes, stacked at the upper edge of the first half of the viewport, below the header.
class Badges {
 public:
  enum class Sign { kPlaying, kPaused, kMode };

  // Called once per frame, before any is drawn.
  void begin_frame() { drawn_ = 0; }
  // Draws the next badge, at least `min_ems` wide, so that its width does not change with its text. The
  // landmark is its name in tests.
  void draw(const ViewState& view, Sign sign, const std::string& text, const char* landmark,
            float min_ems = 0);

 private:
  int drawn_ = 0;
};

}  // namespace kerf
