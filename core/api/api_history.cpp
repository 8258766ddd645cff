#include "core/api/api_internal.h"
#include "core/document/document.h"

void kerf_world::keep_job() {
  const size_t position = document.history().position();
  jobs.resize(position + 1);
  jobs[position] = job;
  jobs[position]->step_s.clear();
}

void kerf_world::restore_job() {
  const size_t position = document.history().position();
  if (position >= jobs.size() || !jobs[position]) return;
  std::vector<double> durations = std::move(job.step_s);
  job = *jobs[position];
  job.step_s = std::move(durations);
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
    world->restore_job();
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
