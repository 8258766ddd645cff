#pragma once

#include <string>
#include <vector>

#include "ui/editor/shared/workspace.h"
#include "ui/window/layout.h"

namespace kerf {

// The state from which the tour detects that a step is done.
struct TourMoment {
  size_t position = 0;  // of the history
  bool cuts = false;    // a stroke is drawn or being cut
  Vec3 eye{0};          // of the camera
  Ticks clock = 0;      // of the world
  bool plays = false, shows_edges = false, shows_boxes = false;
  double edge = 0;  // m, of the resolution
  bool saved = false;
};
TourMoment tour_moment(const Workspace& workspace);

// A step of the tour: its task, the part of the window to which it points, and the condition for its end.
struct TourStep {
  std::string title, text;
  const char* part = "";  // a landmark; empty: the viewport
  std::function<bool(const TourMoment& begin, const TourMoment& now)> done;
};

// Returns the tour "first five minutes": cut, undo, orbit, let time pass, refine, look into the tree, save.
// Keys are named as they are bound.
std::vector<TourStep> first_five_minutes(const ViewState& view);

class Tour {
 public:
  // Precondition: there are steps.
  void begin(std::vector<TourStep> steps, const TourMoment& now);
  void end() { steps_.clear(); }
  bool is_on() const { return !steps_.empty(); }

  // Called once per frame while the tour is on: continues when the step is done.
  void follow(const TourMoment& now);
  // Skips to the next step, or ends the tour after the last one. Precondition of this and the following:
  // is_on().
  void skip(const TourMoment& now);
  void go_back(const TourMoment& now);
  const TourStep& step() const;
  size_t at() const { return at_; }
  size_t count() const { return steps_.size(); }

 private:
  void go_to(size_t step, const TourMoment& now);

  std::vector<TourStep> steps_;
  size_t at_ = 0;
  TourMoment begin_;  // at the start of the step
};

enum class TourMove { kNone, kBack, kOn, kEnd };

// Draws the step of a tour as a card with a frame around `part`, and returns the user's request. `part` is
// nullopt if the step points at the viewport, or the part is not visible.
TourMove draw_tour_card(const Tour& tour, const Area& picture, const std::optional<Area>& part);

}  // namespace kerf
