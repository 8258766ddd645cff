#include "ui/render/scene_strokes.h"

namespace kerf {

namespace {

constexpr size_t kMovesOfStep = 64;

CutSettings settings_of(const StrokePath& stroke, double diagonal) {
  CutSettings settings;
  settings.laser.radius = stroke.radius.value_or(diagonal / 400);
  settings.laser.range = stroke.range.value_or(Interval{0, 10 * diagonal});
  settings.laser.power = stroke.power.value_or(settings.laser.power);
  settings.resolution.target_edge = settings.laser.radius / 4;
  return settings;
}

}  // namespace

Status cut_strokes(Document& document, const std::vector<StrokePath>& strokes,
                   const std::function<void(const StepResult&)>& told) {
  const double diagonal = document.world().bounds().diagonal();
  for (const StrokePath& stroke : strokes) {
    if (stroke.keys.empty()) continue;
    document.apply(BeginStroke{settings_of(stroke, diagonal), stroke.keys.front()});
    for (size_t k = 1; k < stroke.keys.size(); ++k) document.apply(MoveStroke{stroke.keys[k]});
    document.apply(EndStroke{});
    while (document.waiting() > 0) {
      const Result<StepResult> step = document.step(kMovesOfStep);
      if (!step) return step.error();
      told(*step);
    }
  }
  return Done{};
}

}  // namespace kerf
