#pragma once

#include <optional>
#include <vector>

#include "ui/editor/path/path_work.h"
#include "ui/editor/shared/picture/first_picture.h"

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

}  // namespace kerf
