#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ui/editor/path/path_work.h"
#include "ui/editor/shared/viewport.h"

struct ImDrawList;

namespace kerf {

// A point of the path in the first half of the picture. Places are of the window, screen coordinates.
struct PathMark {
  PathPoint point;
  size_t number = 0;    // counted from 0 over all strokes
  Vec2 target{0};       // where the beam aims
  bool hidden = false;  // a surface is in front of it
};

// The points that are drawn: those in front of the eye, without those that would lie on the dot of the one
// before.
std::vector<PathMark> path_marks(const PathWork& path, const World& world, const FirstPicture& picture);

// The handle that turns the beam of the chosen point: a knob on its beam, towards its origin.
struct PathKnob {
  Vec3 at{0};           // m
  double distance = 0;  // m from the target
  Vec2 place{0};
};
std::optional<PathKnob> path_knob(const PathWork& path, const FirstPicture& picture);

// What is at a place: the dot of a point, or the knob of the chosen one where that is nearer.
struct PathGrip {
  PathPoint point;
  bool is_knob = false;
};
std::optional<PathGrip> path_grip(const PathWork& path, const World& world, const FirstPicture& picture,
                                  Vec2 at);

// Draws the path: its lines and dots on the surface, an arrow for the beam of each point, and the knob of the
// chosen one. What a surface hides is drawn faintly.
void draw_path(const PathWork& path, const World& world, const FirstPicture& picture, ImDrawList& list);

// What the left button does while the path is in hand. A press on a surface adds a point there, which the
// drag goes on to move; the beam of a new point stands upright on the surface. A drag of a dot moves its
// point over the surfaces, and the beam keeps its angle to them; a drag of the knob turns the beam of the
// chosen point about the place that it aims at. Places of the pointer are of the window, screen coordinates.
class PathTool {
 public:
  // What a new point needs besides its place.
  struct Beam {
    double radius = 0.01;  // m
    double height = 0.1;   // m, of its origin over the surface
    double speed = 1;      // m/s, of a path that begins with it
  };

  // The usual beam in a world, with this radius (m).
  static Beam beam_for(const World& world, double radius);

  // Returns why nothing happened, or an empty text.
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
  bool edits_ = false;  // the drag has begun a step of the undo
  Vec2 pressed_at_{0};
};

}  // namespace kerf
