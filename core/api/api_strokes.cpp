#include <chrono>
#include <cmath>
#include <limits>

#include "core/api/api_internal.h"
#include "core/base/platform.h"
#include "core/document/command_queue.h"
#include "core/document/document.h"
#include "core/document/stroke_path.h"

namespace kerf {

namespace {

// Of a unit of work; the result does not depend on them.
constexpr size_t kFacesAtOnce = 250, kMovesAtOnce = 4;

Status begin_stroke(kerf_world& world, const kerf_stroke* stroke, const kerf_cut_settings* given) {
  const auto settings = read_settings(given);
  if (!settings) return settings.error();
  if (settings->material != nullptr)
    return bad_input("material: must be null for a stroke in steps; set it on the bodies");
  auto all = stroke_commands_of(world, stroke, 1, *settings);
  if (!all) return all.error();
  auto& [path, commands] = all->front();
  std::get<BeginStroke>(commands.front()).settings.faces_per_step = kFacesAtOnce;
  RunningStroke running{std::move(path),
                        0,
                        world.job,
                        world.settings,
                        world.document.history().position(),
                        world.document.history().window(),
                        ThermalTotals(world)};
  running.begin_time = running.last.times.front();
  begin_job(world, commands.front());
  world.job.begin_stroke();
  world.document.set_window(std::numeric_limits<size_t>::max());
  world.document.set_face_budget(usual_face_budget(machine_memory()));
  commands.pop_back();  // the end
  for (const Command& command : commands) world.document.apply(command);
  world.job.steps += commands.size() - 1;
  running.last.keys.erase(running.last.keys.begin(), running.last.keys.end() - 1);
  running.last.times.erase(running.last.times.begin(), running.last.times.end() - 1);
  world.stroke = std::move(running);
  return Done{};
}

Status add_pose(kerf_world& world, RunningStroke& stroke, const kerf_keyframe& key) {
  if (stroke.ended) return bad_input("the stroke was ended; begin another one");
  if (std::isfinite(key.time) && !std::isfinite(key.time - stroke.begin_time))
    return bad_input("key: the time is too far from that of the first key");
  if (const Status added = add_key(key, "key", stroke.last); !added) return added;
  stroke.last.keys.erase(stroke.last.keys.begin());
  stroke.last.times.erase(stroke.last.times.begin());
  world.document.apply(MoveBeam{stroke.last.keys.front(), stroke.last.times.front() - stroke.begin_time});
  ++world.job.steps;
  return Done{};
}

Status end_stroke(kerf_world& world, RunningStroke& stroke) {
  if (stroke.ended) return bad_input("the stroke was ended already");
  world.document.apply(EndStroke{});
  stroke.ended = true;
  return Done{};
}

void leave_stroke(kerf_world& world) {
  world.document.set_window(world.stroke->window);
  world.stroke.reset();
}

// A step that failed may have undone the stroke already, which must not be redone.
Status cancel_stroke(kerf_world& world, RunningStroke& stroke) {
  const bool exists = world.document.history().position() > stroke.position;
  const Outcome back = exists ? world.document.cancel_stroke() : Outcome();
  if (!exists) world.document.drop_undone();
  world.changes.record(world.document.world(), back.delta);
  world.changes.on_undo(world.document.history().position());
  world.job = std::move(stroke.before);
  world.settings = std::move(stroke.settings_before);
  leave_stroke(world);
  return back.ok() ? Status(Done{}) : back.error();
}

// Executes a unit of work. If it fails, also for lack of memory, cancels the stroke.
Result<StepResult> step_or_cancel(kerf_world& world, RunningStroke& stroke) {
  try {
    Result<StepResult> some = world.document.step(kMovesAtOnce);
    if (some) return some;
    (void)cancel_stroke(world, stroke);
    world.changes.lose();
    return some;
  } catch (...) {
    world.changes.lose();
    (void)cancel_stroke(world, stroke);
    throw;
  }
}

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

Status step_stroke(kerf_world& world, RunningStroke& stroke, size_t max_faces, double max_seconds,
                   kerf_stroke_progress& progress) {
  const auto begin = Clock::now();
  Document& document = world.document;
  while (document.waiting() > 0) {
    const auto begun = Clock::now();
    const Result<StepResult> some = step_or_cancel(world, stroke);
    if (!some) return some.error();
    world.changes.record(document.world(), some->delta);
    world.job.record_step(*some, document.world(), seconds_since(begun));
    progress.faces += some->statistics.faces_made + some->delta.removed_faces + some->delta.solid.wall_faces;
    if (progress.faces >= max_faces || seconds_since(begin) >= max_seconds) break;
  }
  progress.waiting = document.waiting();
  progress.is_idle = progress.waiting == 0;
  progress.is_finished = stroke.ended && progress.is_idle;
  progress.removed_faces = world.job.removed_faces - stroke.before.removed_faces;
  progress.removed_area = world.job.removed_area - stroke.before.removed_area;
  stroke.thermal.set(world, progress);
  if (progress.is_finished) {
    world.job.end_stroke();
    world.keep();
    leave_stroke(world);
  }
  progress.seconds = seconds_since(begin);
  return Done{};
}

}  // namespace
}  // namespace kerf

kerf_result kerf_stroke_begin(kerf_world* world, const kerf_stroke* stroke,
                              const kerf_cut_settings* settings) {
  if (stroke == nullptr) return kerf::set_error(KERF_INVALID_ARGUMENT, "stroke: must not be null");
  return kerf::change_world(
      world, nullptr, [&](const kerf::Progress&) { return kerf::begin_stroke(*world, stroke, settings); });
}

kerf_result kerf_stroke_add_pose(kerf_world* world, const kerf_keyframe* key) {
  if (key == nullptr) return kerf::set_error(KERF_INVALID_ARGUMENT, "key: must not be null");
  return kerf::change_stroke(
      world, [&](kerf::RunningStroke& stroke) { return kerf::add_pose(*world, stroke, *key); });
}

kerf_result kerf_stroke_end(kerf_world* world) {
  return kerf::change_stroke(world,
                             [&](kerf::RunningStroke& stroke) { return kerf::end_stroke(*world, stroke); });
}

kerf_result kerf_stroke_step(kerf_world* world, size_t max_faces, double max_seconds,
                             kerf_stroke_progress* progress) {
  return kerf::change_stroke(world, [&](kerf::RunningStroke& stroke) -> kerf::Status {
    kerf_stroke_progress own{};
    if (!(max_seconds >= 0)) return kerf::bad_input("max_seconds: must not be negative");
    if (progress != nullptr) {
      if (const kerf::Status valid = kerf::check_size(*progress, "progress"); !valid) return valid;
    }
    const kerf::Status done = kerf::step_stroke(*world, stroke, max_faces, max_seconds, own);
    if (done && progress != nullptr) kerf::write_struct(own, *progress);
    return done;
  });
}

kerf_result kerf_stroke_cancel(kerf_world* world) {
  return kerf::change_stroke(
      world, [&](kerf::RunningStroke& stroke) { return kerf::cancel_stroke(*world, stroke); });
}
