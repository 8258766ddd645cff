#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ui/editor/path/path_work.h"
#include "ui/editor/shared/viewport.h"

struct ImDrawList;

namespace kerf {

// A visible point of the path in the first half. Places are in the window, in screen coordinates.
struct PathMark {
  PathPoint point;
  size_t number = 0;    // from 0, over all strokes
  Vec2 target{0};       // place of the target
  bool hidden = false;  // behind a surface
};

// Returns the points to draw: those in front of the eye, except those whose dot would cover that of the
// previous one.
std::vector<PathMark> path_marks(const PathWork& path, const World& world, const FirstPicture& picture);

// Handle that turns the beam of the selected point: a knob on its beam, towards its origin.
struct PathKnob {
  Vec3 at{0};           // world [m]
  double distance = 0;  // from the target [m]
  Vec2 place{0};
};
std::optional<PathKnob> path_knob(const PathWork& path, const FirstPicture& picture);

// Hit test at a place: the dot of a point, or the knob of the selected one if that is nearer.
struct PathGrip {
  PathPoint point;
  bool is_knob = false;
};
std::optional<PathGrip> path_grip(const PathWork& path, const World& world, const FirstPicture& picture,
                                  Vec2 at);

// Draws the path: lines and dots on the surface, an arrow for the beam of each point, and the knob of the
// selected one. Parts behind a surface are drawn faintly.
void draw_path(const PathWork& path, const World& world, const FirstPicture& picture, ImDrawList& list);

// Left button of the Path tool. A press on a surface adds a point there, which the drag moves; its beam is
// perpendicular to the surface. Dragging a dot moves its point over the surfaces and keeps the angle of its
// beam to them. Dragging the knob turns the beam of the selected point about its target. `pointer` is in the
// window, in screen coordinates.
class PathTool {
 public:
  struct Beam {
    double radius = 0.01;  // [m]
    double height = 0.1;   // of its origin over the surface [m]
    double speed = 1;      // of a path that begins with it [m/s]
  };

  // Returns the default beam for a world, with this radius [m].
  static Beam beam_for(const World& world, double radius);

  // Returns the reason if nothing happened, else an empty text.
  std::string press(PathWork& path, const World& world, const ViewState& view, Vec2 pointer, bool new_stroke,
                    const Beam& beam);
  void move(PathWork& path, const World& world, const ViewState& view, Vec2 pointer);
  void release() { grip_ = Grip::kNone; }

 private:
  enum class Grip { kNone, kTarget, kKnob };
  void take(Grip grip, bool edits, Vec2 pointer);
  void drag_target(PathWork& path, const World& world, const ViewState& view, Vec2 pointer) const;
  void drag_knob(PathWork& path, const ViewState& view, Vec2 pointer) const;

  Grip grip_ = Grip::kNone;
  bool edits_ = false;  // the drag has begun an undo step
  Vec2 pressed_at_{0};
};

}  // namespace kerf
