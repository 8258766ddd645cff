#pragma once

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/document/document.h"
#include "core/world/world.h"
#include "ui/editor/shared/laser_controls.h"
#include "ui/editor/shared/viewport.h"
#include "ui/render/passes/beam_effects.h"
#include "ui/window/layout.h"

struct ImDrawList;

namespace kerf {

// Progress through the queue of a document, for the status bar. Short work is not shown, to avoid flicker.
class CutProgress {
 public:
  // Call once per frame after processing the queue, with the seconds since the last call. `held_back`:
  // single steps hold the queue, so nothing is shown.
  void follow(const Document& document, bool held_back, double seconds);
  // Returns true if work is shown and can be stopped.
  bool can_stop() const { return lasts() && work_ == Work::kCut; }
  // Text of the current work, or empty: "Cutting, 40 %, Esc to stop".
  std::string text() const;

 private:
  enum class Work {
    kNone,
    kCut,
    kEnd,     // end of a stroke, cannot be stopped
    kSearch,  // for separated pieces
  };
  static Work work_of(const Document& document);
  bool lasts() const;

  Work work_ = Work::kNone;
  size_t waits_ = 0, done_ = 0;  // queued units of work, since the queue was last empty
  double seconds_ = 0;           // since then
};

// Strokes that are not cut yet: those queued after the current one, and one that single steps hold back.
// Their beams are drawn dimmed at their start, with the reason.
class WaitingStrokes {
 public:
  struct Stroke {
    size_t step = 0;  // history entry
    std::string waits_for;
    BeamPicture beam;
  };

  // Call once per frame after processing the queue, with the seconds since the last call. `held_back`: the
  // last stroke waits for the user. Returns true if the beams have changed. Omits strokes that wait only
  // briefly for another one. Casts rays for each stroke that begins to wait.
  bool follow(const Document& document, FileUnit unit, bool held_back, double seconds);

  const std::vector<Stroke>& strokes() const { return strokes_; }
  // Marks each beam, and draws each reason once, next to the first visible beam that has it.
  void draw(const ViewState& view, ImDrawList& list) const;

 private:
  std::vector<Stroke> strokes_;
  size_t revision_ = 0;  // of the document
  double behind_ = 0;    // s, for which strokes have waited for the current one
  bool held_back_ = false;
};

// Sparks and smoke where the laser removes faces, if enabled in the view, and the beams of waiting strokes.
class BeamSparks {
 public:
  // Advances the particles by `seconds` and passes them to the view. `waiting_changed`: `waiting` has
  // changed since the last call.
  void advance(double seconds, const LaserTool& beam, const Document& document, const WaitingStrokes& waiting,
               bool waiting_changed, ViewState& view);
  // Removes the particles because the document was replaced.
  void forget(ViewState& view);
  bool moving() const { return !particles_.empty(); }

 private:
  Particles particles_;
  bool had_particles_ = false;
  double removed_ = 0;  // kg, at the last call
};

// Keeps the pointer on a straight line while Shift is held: from its place when Shift was pressed, in the
// direction of its first eight pixels, rounded to 15 degrees.
class StraightLine {
 public:
  // Returns the place for a place of the pointer (screen coordinates). Called for each of its moves.
  Vec2 follow(Vec2 pointer, bool shift);
  // The angle of the line from the right, counter-clockwise [degrees, 0 to 180]; nullopt without a line.
  std::optional<double> degrees() const;

 private:
  std::optional<Vec2> last_, from_, way_;
};

// Projects the corners of a box in the world into a viewport, in screen coordinates; nullopt if a corner
// lies behind the eye.
std::optional<std::array<Vec2, 8>> seen_corners(const World::Bounds& bounds, const CameraView& view,
                                                const Area& picture);

// Returns true if an area intersects the convex hull of points. Method: separating axes; disjoint convex
// sets are disjoint along a normal of an edge of one of them. Precondition: `points` is not empty.
bool meets_hull(const Area& area, std::span<const Vec2> points);

// Returns a free place of this size along the edges of a viewport, at `margin` from them: preferably at the
// bottom, else at the top; preferably in the middle, else at the left or right. Returns nullopt if `is_free`
// rejects all of them.
std::optional<Area> free_place(const Area& picture, Vec2 size, double margin,
                               const std::function<bool(const Area&)>& is_free);

// Draws the hints of the first launch where they cover neither the world, the axes nor `taken`; else draws
// nothing.
void draw_hint_box(const World& world, const ViewState& view, const Area& taken);

}  // namespace kerf
