#include "ui/render/picture.h"

#include "core/document/replay.h"
#include "ui/render/scene_strokes.h"
#include "ui/render/studio.h"

namespace kerf {

namespace {

// A step that fails here failed when the journal was made too.
void replay_all(const Journal& journal, Document& document, Studio& studio) {
  Replay replay(journal, document);
  Walk how;
  how.told = [&](const Result<StepResult>& step) -> Status {
    studio.follow(document.world(), step ? &*step : nullptr);
    return Done{};
  };
  (void)replay.run(how);  // nobody stops it
}

}  // namespace

Status render_picture(OpenedFile work, const PictureOptions& options, const std::filesystem::path& png) {
  auto studio = Studio::open(work.scene, options);
  if (!studio) return studio.error();
  Document document(std::move(work.scene.world));
  const Status cut = cut_strokes(document, work.scene.strokes,
                                 [&](const StepResult& step) { studio->follow(document.world(), &step); });
  if (!cut) return cut.error();
  replay_all(work.journal, document, *studio);
  studio->show_graph(document);
  studio->show_bodies_ahead(document.world());
  studio->spread(document.world(), options.spread);
  studio->draw(document.world(), std::nullopt);
  return studio->write(png);
}

}  // namespace kerf
