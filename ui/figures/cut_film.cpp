#include "core/document/journal/opened_file.h"
#include "core/document/journal/replay.h"
#include "ui/figures/figure_films.h"
#include "ui/render/picture/film.h"

namespace kerf {

Status film_cut(const std::filesystem::path& journal, const FilmFormat& format, const Progress& progress) {
  auto work = open_journal(journal);
  if (!work) return work.error();
  const auto options = options_for(journal, work->scene, format.width, format.height);
  if (!options) return options.error();
  auto film = Film::begin(work->scene, {*options, format.frames_per_second, format.folder});
  if (!film) return film.error();
  Document document(std::move(work->scene.world));
  Replay replay(work->journal, document);
  QueueRun how;
  how.moves_a_step = 1;
  how.progress = &progress;
  how.told = [&](const Result<StepResult>& step) { return film->follow(document, step ? &*step : nullptr); };
  if (const Status run = replay.run(how); !run) return run;
  return film->end(document);
}

}  // namespace kerf
