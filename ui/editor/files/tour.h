#pragma once

#include <string>
#include <vector>

#include "ui/editor/shared/workspace.h"
#include "ui/window/layout.h"

namespace kerf {

// What the tour looks at to see whether the user has done what a step asks for.
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

// A step of the tour: what it asks for, which part of the window it points at, and when it is done.
struct TourStep {
  std::string title, text;
  const char* part = "";  // a landmark; empty: the picture
  std::function<bool(const TourMoment& begin, const TourMoment& now)> done;
};

// The first five minutes with Kerf, step by step: cut, take back, look round, let time pass, refine, look
// into the tree, save. Keys are named as they are bound.
std::vector<TourStep> first_five_minutes(const ViewState& view);

// Where a user is in a tour.
class Tour {
 public:
  // Preconditions: there are steps.
  void begin(std::vector<TourStep> steps, const TourMoment& now);
  void end() { steps_.clear(); }
  bool is_on() const { return !steps_.empty(); }

  // Goes on when the step is done; to be called once a frame while it is on.
  void follow(const TourMoment& now);
  // Goes on without that, and ends after the last step. Precondition of this and of those below: it is on.
  void skip(const TourMoment& now);
  void go_back(const TourMoment& now);
  const TourStep& step() const;
  size_t at() const { return at_; }
  size_t count() const { return steps_.size(); }

 private:
  void go_to(size_t step, const TourMoment& now);

  std::vector<TourStep> steps_;
  size_t at_ = 0;
  TourMoment begin_;  // of the step
};

enum class TourMove { kNone, kBack, kOn, kEnd };

// Draws the step of a tour as a card with a frame around what it points at, and returns what the user wants.
// `part` is where that is; nothing where it is the picture, or is not seen at the moment.
TourMove draw_tour_card(const Tour& tour, const Area& picture, const std::optional<Area>& part);

}  // namespace kerf
