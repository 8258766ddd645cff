#include "ui/render/picture/scene_strokes.h"

#include "core/document/files/stroke_settings.h"
#include "core/document/history/run_queue.h"

namespace kerf {

Status cut_strokes(Document& document, const std::vector<StrokePath>& strokes,
                   const std::function<void(const StepResult&)>& told, const Progress* progress) {
  const double diagonal = document.world().bounds().diagonal();
  for (size_t i = 0; i < strokes.size(); ++i) {
    for (const Command& command : scene_stroke_commands(strokes[i], diagonal)) document.apply(command);
    const double share = 1 / static_cast<double>(strokes.size()), before = share * static_cast<double>(i);
    const Progress cutting = share_of(progress, before, before + share);
    QueueRun how;
    how.progress = &cutting;
    how.told = [&](const Result<StepResult>& step) -> Status {
      if (!step) return step.error();
      told(*step);
      return Done{};
    };
    if (const Status ran = run_queue(document, how); !ran) return ran;
  }
  return Done{};
}

}  // namespace kerf
