#include <algorithm>
#include <functional>
#include <utility>

#include "core/api/api_internal.h"
#include "core/document/document.h"

void kerf_world::record_loaded(const kerf::Body& body, const kerf::Placement& placement) {
  job.record_loaded(body.loaded);
  kerf::Bounds all = kerf::Bounds::none();
  for (int corner = 0; corner < 8; ++corner) {
    const auto at = [&](int k) { return corner >> k & 1 ? body.loaded.min[k] : body.loaded.max[k]; };
    all.add(placement.to_world({at(0), at(1), at(2)}));
  }
  if (!bounds) bounds = all;
  bounds->add(all);
}

void kerf_world::keep() {
  kept.resize(document.history().size() + 1);
  std::vector<double> durations = std::exchange(job.step_s, {});
  std::vector<size_t> missed = std::exchange(job.missed, {});
  std::vector<kerf::ScrapCut> scrap = std::exchange(job.scrap, {});
  job.freed_by.share();
  kept[document.history().position()] = Kept{job, settings, bounds, time_left};
  job.step_s = std::move(durations);
  job.missed = std::move(missed);
  job.scrap = std::move(scrap);
}

namespace {

// Moves entries of strokes from number `now` on from a list to `undone`, and back the others of `undone`.
// `before`: the number of strokes before; later strokes replaced those of `undone` below it.
template <typename Entry, typename Stroke>
void move_undone(std::vector<Entry>& list, std::vector<Entry>& undone, size_t before, size_t now,
                 Stroke stroke_of) {
  std::erase_if(undone, [&](const Entry& entry) { return stroke_of(entry) < before; });
  list.insert(list.end(), undone.begin(), undone.end());
  const auto first = std::ranges::lower_bound(list, now, {}, stroke_of);
  undone.assign(first, list.end());
  list.erase(first, list.end());
}

}  // namespace

void kerf_world::restore() {
  const size_t position = document.history().position();
  if (position >= kept.size() || !kept[position]) return;
  std::vector<double> durations = std::move(job.step_s);
  std::vector<size_t> missed = std::move(job.missed);
  std::vector<kerf::ScrapCut> scrap = std::move(job.scrap);
  const size_t before = job.strokes;
  job = kept[position]->job;
  move_undone(missed, undone_missed, before, job.strokes, std::identity());
  move_undone(scrap, undone_scrap, before, job.strokes,
              [](const kerf::ScrapCut& cut) { return cut.at.stroke; });
  job.step_s = std::move(durations);
  job.missed = std::move(missed);
  job.scrap = std::move(scrap);
  settings = kept[position]->settings;
  bounds = kept[position]->bounds;
  time_left = kept[position]->time_left;
}

namespace kerf {

namespace {

kerf_result travel(kerf_world* world, const Command& command, int* done) {
  return change_world(world, nullptr, [&](const Progress& progress) -> Status {
    Document& document = world->document;
    const size_t before = document.history().position();
    Outcome outcome = document.apply(command, &progress);
    QueueRun run;
    run.told = [&](const Result<StepResult>& step) -> Status {
      if (!step) return step.error();
      outcome.delta.append(step->delta);
      return Done{};
    };
    const Status ran = outcome.ok() ? run_queue(document, run) : Status(outcome.error());
    world->changes.record(document.world(), outcome.delta);
    world->changes.on_undo(document.history().position());
    world->restore();
    if (!ran) return ran;
    if (done != nullptr) *done = document.history().position() != before;
    return Done{};
  });
}

}  // namespace
}  // namespace kerf

kerf_result kerf_world_undo(kerf_world* world, int* done) { return kerf::travel(world, kerf::Undo{}, done); }
kerf_result kerf_world_redo(kerf_world* world, int* done) { return kerf::travel(world, kerf::Redo{}, done); }

kerf_result kerf_world_set_undo_memory(kerf_world* world, size_t bytes) {
  return kerf::change_world(world, nullptr, [&](const kerf::Progress&) -> kerf::Status {
    world->document.set_window(bytes);
    return kerf::Done{};
  });
}
