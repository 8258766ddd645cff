#include "ui/editor/welcome/tour.h"

#include "core/base/assert.h"
#include "ui/editor/shared/panels/shortcut_text.h"

namespace kerf {

namespace {

constexpr Ticks kSeenFalling = kTicksPerSecond;

// "Ctrl+Z takes the stroke back."; the name of the action where no key is bound to it.
std::string by_key(const ViewState& view, const std::string& action, const std::string& rest) {
  const std::string key = shortcut_of(view, action);
  return (key.empty() ? "\"" + action + "\"" : key) + rest;
}

}  // namespace

TourMoment tour_moment(const Workspace& on) {
  const Document& document = on.work.document;
  const ShowOptions& show = on.view.look.show;
  return {.position = document.history().position(),
          .cuts = on.cutting(),
          .eye = on.view.seen_first().eye,
          .clock = document.world().clock(),
          .plays = on.plays,
          .shows_edges = show.wire,
          .shows_boxes = show.aabb || show.aabb_hit,
          .edge = on.laser.resolution.edge_fraction * on.laser.radius,
          .saved = !on.work.file.empty() && on.work.saved_commands == document.journal().size()};
}

std::vector<TourStep> first_five_minutes(const ViewState& view) {
  using M = TourMoment;
  return {
      {"Cut",
       "Hold the left button to the left of the windscreen, drag through the windows past the back of the "
       "car, "
       "and release.",
       "", [](const M& begin, const M& now) { return now.position > begin.position && !now.cuts; }},
      {"Take it back", by_key(view, "Undo", " takes the stroke back: all is whole again."), "History",
       [](const M& begin, const M& now) { return now.position < begin.position; }},
      {"Do it again", by_key(view, "Redo", " cuts it again. The History panel goes to any step."), "History",
       [](const M& begin, const M& now) { return now.position > begin.position; }},
      {"Look round",
       "Drag with the middle button, or with Alt and the left one, to look round; the wheel comes closer.",
       "", [](const M& begin, const M& now) { return now.eye != begin.eye; }},
      {"Let it fall",
       by_key(view, "Play", " lets time pass: what is cut off falls. The Move tab sets how fast."),
       "tab Move",
       [](const M& begin, const M& now) { return now.plays && now.clock >= begin.clock + kSeenFalling; }},
      {"Stop time", by_key(view, "Play", " again stops it; ") + by_key(view, "Undo", " puts all back."), "",
       [](const M&, const M& now) { return !now.plays; }},
      {"See the faces",
       by_key(view, "Wireframe", " shows the edges: Kerf refines where the beam bites, and nowhere else."),
       "tab Look", [](const M& begin, const M& now) { return now.shows_edges != begin.shows_edges; }},
      {"Refine", "Drag the slider Edge in the Resolution panel: the last stroke is cut again while it moves.",
       "resolution size", [](const M& begin, const M& now) { return now.edge != begin.edge; }},
      {"Look into the tree",
       by_key(view, "Boxes",
              " shows the boxes of the AABB tree that finds the faces: red where the beam was."),
       "tab Look", [](const M& begin, const M& now) { return now.shows_boxes != begin.shows_boxes; }},
      {"Keep it",
       by_key(view, "Save",
              " writes all of it, with everything that can be undone. This was the tour; Help has it "
              "and all keys."),
       "", [](const M& begin, const M& now) { return now.saved && !begin.saved; }},
  };
}

void Tour::begin(std::vector<TourStep> steps, const TourMoment& now) {
  KERF_ASSERT(!steps.empty());
  steps_ = std::move(steps);
  go_to(0, now);
}

void Tour::follow(const TourMoment& now) {
  if (is_on() && step().done(begin_, now)) skip(now);
}

void Tour::skip(const TourMoment& now) {
  KERF_ASSERT(is_on());
  if (at_ + 1 == steps_.size()) return end();
  go_to(at_ + 1, now);
}

void Tour::go_back(const TourMoment& now) {
  KERF_ASSERT(is_on());
  if (at_ > 0) go_to(at_ - 1, now);
}

const TourStep& Tour::step() const {
  KERF_ASSERT(is_on());
  return steps_[at_];
}

void Tour::go_to(size_t step, const TourMoment& now) {
  at_ = step;
  begin_ = now;
}

}  // namespace kerf
