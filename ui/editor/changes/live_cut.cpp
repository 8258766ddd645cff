#include "ui/editor/changes/live_cut.h"

#include "ui/editor/view/piece_set.h"
#include "ui/render/spread.h"

namespace kerf {

namespace {
constexpr double kStepSeconds =
    0.020;  // of cutting in one frame, or as long as drawing takes if that is more
constexpr size_t kMovesOfStep = 16;
}  // namespace

void LiveCut::advance() {
  const double began = on_.clock.seconds();
  const double until = began + std::max(kStepSeconds, on_.picture.seconds());
  seconds_ = 0;
  const bool cools = on_.work.document.only_cools();
  const bool first = cut_first(until), twin = cut_twin(until);
  if (!first && !twin) return;
  ViewState& view = on_.view;
  if (first && view.spread > 0) spread_pieces(on_.work.document.world(), view.spread, view.look);
  seconds_ = on_.clock.seconds() - began;
  (cools && !twin ? view.heat_old : view.picture_old) = true;
  on_.figures.world_changed = true;
}

bool LiveCut::cut_first(double until) {
  const Document& document = on_.work.document;
  if (!first_waits() || on_.changes.is_pending()) return false;
  const bool beam = on_.hand.beam.cutting() || document.beam_waits();
  while (first_waits() && on_.clock.seconds() < until) {
    if (!on_.changes.step([](Document& d) { return d.step(kMovesOfStep); })) break;
  }
  if (beam) on_.hand.beam.find_strike(document);
  return true;
}

bool LiveCut::cut_twin(double until) {
  SplitView& split = on_.split;
  if (!split.shown) return false;
  const Result<Renderer*> half = on_.picture.second();
  if (!half) {
    split.shown = false;
    on_.message.say(half.error().message, true);
    return false;
  }
  Renderer& renderer = **half;
  const bool anew = split.twin.follow(on_.work.document, split.resolution);
  if (anew) on_.changes.show_world(split.twin.world(), renderer);
  const bool waited = split.twin.waiting() > 0;
  while (split.twin.waiting() > 0 && on_.clock.seconds() < until) {
    const Result<StepResult> step = split.twin.step(kMovesOfStep);
    if (!step) {
      renderer.resend(split.twin.world());
      on_.message.say("In the right half: " + step.error().message, true);
      break;
    }
    renderer.follow(split.twin.world(), step->delta);
    if (on_.view.look.ghost || on_.view.look.show.face_numbers) renderer.catch_up(split.twin.world());
  }
  return anew || waited;
}

}  // namespace kerf
