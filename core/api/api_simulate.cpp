#include <algorithm>
#include <cmath>

#include "core/api/api_internal.h"
#include "core/document/document.h"

namespace kerf {

namespace {

constexpr double kMaxSeconds = 3600;

Status simulate(kerf_world& world, double seconds) {
  if (!(seconds >= 0 && seconds <= kMaxSeconds)) return bad_input("seconds: must be a number from 0 to 3600");
  Document& document = world.document;
  const UndoStack& history = document.history();
  world.time_left += seconds;
  auto ticks = static_cast<Ticks>(std::floor(world.time_left * kTicksPerSecond + 1e-6));
  world.time_left = std::max(0.0, world.time_left - seconds_of_ticks(ticks));
  const bool is_playing =
      history.position() > 0 && std::holds_alternative<Play>(history.last().commands().front());
  if (ticks > 0 && !is_playing) document.apply(Play{});
  QueueRun run;
  run.told = [&](const Result<StepResult>& step) -> Status {
    if (!step) return step.error();
    world.changes.record(document.world(), step->delta);
    return Done{};
  };
  Status ran = Done{};
  while (ticks > 0 && ran) {
    const Ticks now = std::min(ticks, AdvanceTime::kMaxInALine);
    document.apply(AdvanceTime{now, true});
    ran = run_queue(document, run);
    ticks -= now;
  }
  world.keep();
  return ran;
}

}  // namespace
}  // namespace kerf

kerf_result kerf_world_set_environment(kerf_world* world, const double gravity[3], const double* ground) {
  if (gravity == nullptr) return kerf::set_error(KERF_INVALID_ARGUMENT, "gravity: must not be null");
  return kerf::change_world(world, nullptr, [&](const kerf::Progress& progress) -> kerf::Status {
    kerf::Environment around = world->document.world().environment();
    around.gravity = {gravity[0], gravity[1], gravity[2]};
    around.ground.reset();
    if (ground != nullptr) around.ground = *ground;
    if (!kerf::is_finite(around.gravity) || !std::isfinite(around.ground.value_or(0)))
      return kerf::bad_input("gravity and ground: must be finite");
    const auto set = kerf::apply_edit(*world, kerf::SetEnvironment{around}, progress);
    return set ? kerf::Status(kerf::Done{}) : set.error();
  });
}

kerf_result kerf_world_simulate(kerf_world* world, double seconds, const kerf_call_options* options) {
  return kerf::change_world(world, options,
                            [&](const kerf::Progress&) { return kerf::simulate(*world, seconds); });
}
