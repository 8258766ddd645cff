#include "ui/render/picture.h"

#include "core/document/document.h"
#include "core/document/replay.h"
#include "core/document/stroke_settings.h"
#include "ui/render/offscreen_renderer.h"
#include "ui/render/passes/beam_effects.h"

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

namespace {

// A step that fails here also failed when the journal was made.
void replay_all(const Journal& journal, Document& document,
                const std::function<void(const StepResult*)>& told) {
  Replay replay(journal, document);
  QueueRun how;
  how.told = [&](const Result<StepResult>& step) -> Status {
    told(step ? &*step : nullptr);
    return Done{};
  };
  (void)replay.run(how);  // never stopped
}

}  // namespace

Result<PictureOptions> options_for(const std::filesystem::path& file, const Scene& scene, int width,
                                   int height) {
  const auto show = parse_show_list(scene.show);
  if (!show) return bad_input(file.string() + ": /show: " + show.error().message);
  PictureOptions options;
  options.width = width;
  options.height = height;
  options.show = scene.show.empty() ? default_show() : *show;
  return options;
}

Result<RenderedImage> draw_picture(OpenedFile work, const PictureOptions& options) {
  auto opened = OffscreenRenderer::open(work.scene, options);
  if (!opened) return opened.error();
  const auto renderer = std::make_shared<OffscreenRenderer>(std::move(*opened));
  const auto kept = std::make_shared<Document>(std::move(work.scene.world));
  Document& document = *kept;
  std::optional<Pose> beam;
  const auto follow = [&](const StepResult* step) {
    renderer->follow(document.world(), step);
    if (step && step->last) beam = step->last->to;
  };
  const Status cut =
      cut_strokes(document, work.scene.strokes, [&](const StepResult& step) { follow(&step); });
  if (!cut) return cut.error();
  replay_all(work.journal, document, follow);
  renderer->show_graph(document);
  renderer->show_bodies_ahead(document.world());
  renderer->spread(document.world(), options.spread);
  std::optional<BeamPicture> drawn;
  if (options.beam && beam) {
    const double far =
        glm::length(renderer->view().eye - beam->origin) + document.world().bounds().diagonal();
    drawn = picture_of_beam(document.world(), document.history().last_settings(), *beam, far);
  }
  renderer->draw(document.world(), drawn);
  return RenderedImage{kept, renderer};
}

Status render_picture(OpenedFile work, const PictureOptions& options, const std::filesystem::path& png) {
  const auto picture = draw_picture(std::move(work), options);
  return picture ? picture->renderer->write(png) : Status(picture.error());
}

}  // namespace kerf
