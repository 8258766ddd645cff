#include "ui/render/scene_strokes.h"

#include "core/document/stroke_settings.h"

namespace kerf {

namespace {

constexpr size_t kMovesOfStep = 64;

}  // namespace

Status cut_strokes(Document& document, const std::vector<StrokePath>& strokes,
                   const std::function<void(const StepResult&)>& told, const Progress* progress) {
  const double diagonal = document.world().bounds().diagonal();
  for (size_t i = 0; i < strokes.size(); ++i) {
    const StrokePath& stroke = strokes[i];
    if (stroke.keys.empty()) continue;
    CutSettings settings = default_settings(stroke, diagonal);
    settings.resolution.rim = Rim::kSmooth;  // as in the editor
    document.apply(BeginStroke{settings, stroke.keys.front()});
    for (size_t k = 1; k < stroke.keys.size(); ++k) document.apply(MoveStroke{stroke.keys[k]});
    document.apply(EndStroke{});
    while (document.waiting() > 0) {
      if (progress && !progress->report(static_cast<double>(i) / static_cast<double>(strokes.size())))
        return cancelled();
      const Result<StepResult> step = document.step(kMovesOfStep);
      if (!step) return step.error();
      told(*step);
    }
  }
  return Done{};
}

}  // namespace kerf
