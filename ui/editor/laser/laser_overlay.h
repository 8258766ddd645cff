#pragma once

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/document/document.h"
#include "core/world/world.h"
#include "ui/editor/shared/laser_tool.h"
#include "ui/editor/shared/viewport.h"
#include "ui/render/passes/beam_effects.h"
#include "ui/window/layout.h"

struct ImDrawList;

namespace kerf {

// How far the beam has come with what waits in the queue of a document, for the status bar. It is told only
// of work that lasts, because a text that comes and goes only disturbs.
class CutProgress {
 public:
  // To be called once a frame after the queue was worked on; `seconds` have passed since the last call. While
  // it is `held_back`, nobody waits for the queue.
  void follow(const Document& document, bool held_back, double seconds);
  // Whether there is such work, and it can be stopped.
  bool can_stop() const { return lasts() && work_ == Work::kCut; }
  // What is at work, or empty: "Cutting, 40 %, Esc stops".
  std::string text() const;

 private:
  enum class Work {
    kNone,
    kCut,
    kEnd,     // the end of a stroke, which is not stopped
    kSearch,  // for what came apart
  };
  static Work work_of(const Document& document);
  bool lasts() const;

  Work work_ = Work::kNone;
  size_t waits_ = 0, done_ = 0;  // moves and the like, since the queue was empty last
  double seconds_ = 0;           // since then
};

// The strokes of which nothing is cut yet: those behind the one that is being cut, and one that single steps
// hold back. Their beams are drawn dimmed where they begin, with what they wait for.
class WaitingStrokes {
 public:
  struct Stroke {
    size_t step = 0;  // of the history
    std::string waits_for;
    BeamPicture beam;
  };

  // To be called once a frame after the queue was worked on; `seconds` have passed since the last call.
  // `held_back`: the last stroke waits for the user. Returns whether the beams have changed. Casts rays for
  // each stroke that began to wait. A stroke that waits only briefly for another one is left out.
  bool follow(const Document& document, FileUnit unit, bool held_back, double seconds);

  const std::vector<Stroke>& strokes() const { return strokes_; }
  // Writes at each beam what it waits for.
  void draw(const ViewState& view, ImDrawList& list) const;

 private:
  std::vector<Stroke> strokes_;
  size_t revision_ = 0;  // of the document
  double behind_ = 0;    // s, that strokes have waited for one that is being cut
  bool held_back_ = false;
};

// The effects of the editor's laser: sparks and smoke where it removes faces, as long as the view's switch is
// on, and the beams of strokes that wait.
class BeamSparks {
 public:
  // Lets time pass (s) for them and shows them in the view. `waiting_changed`: since the last call.
  void advance(double seconds, const LaserTool& beam, const Document& document, const WaitingStrokes& waiting,
               bool waiting_changed, ViewState& view);
  // Whether some are in the air.
  bool moving() const { return !particles_.empty(); }

 private:
  Particles particles_;
  bool had_particles_ = false;
  double removed_ = 0;  // kg, when it was last looked
};

// The corners of a box of the world as they are seen in a picture, in screen coordinates; nothing where one
// of them lies behind the eye.
std::optional<std::array<Vec2, 8>> seen_corners(const World::Bounds& bounds, const CameraView& view,
                                                const Area& picture);

// Whether an area meets the convex hull of some points, by the separating axis theorem: two convex sets that
// are disjoint are disjoint along a normal of an edge of one of them. Precondition: there is a point.
bool meets_hull(const Area& area, std::span<const Vec2> points);

// A place for a box of this size along the edges of a picture where `is_free`: at the bottom if possible,
// otherwise at the top; in the middle if possible, otherwise at the left or right. `margin`: to the edges of
// the picture. Nothing if there is no such place.
std::optional<Area> free_place(const Area& picture, Vec2 size, double margin,
                               const std::function<bool(const Area&)>& is_free);

// Draws the hints of a first visit where they cover neither the world nor the axes nor `taken`, or not at
// all.
void draw_hint_box(const World& world, const ViewState& view, const Area& taken);

}  // namespace kerf
