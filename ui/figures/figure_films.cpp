#include "ui/figures/figure_films.h"

#include <algorithm>
#include <cmath>

#include "core/base/assert.h"
#include "core/base/deterministic_math.h"
#include "core/base/tick.h"
#include "core/document/cut_effects.h"
#include "core/document/journal.h"
#include "core/document/replay.h"
#include "core/game/match/recording.h"
#include "ui/game/game_camera.h"
#include "ui/game/match_picture.h"
#include "ui/gl/image.h"
#include "ui/render/offscreen_renderer.h"

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

namespace {

constexpr double kFilmFieldOfView = 45;  // degrees

// Returns the best moment of a match; nullopt if `progress` stopped the search.
std::optional<MatchMoment> best_moment(const MatchSetup& setup, const std::vector<Controls>& controls,
                                       const Progress& progress) {
  ScoreLog log;
  Match match(setup);
  for (const Controls& c : controls) {
    if (!progress.report(0)) return std::nullopt;
    match.tick(c);
    log.on_tick(match);
  }
  return log.best();
}

}  // namespace

Status film_fight(const std::filesystem::path& file, const FilmFormat& format, const Progress& progress) {
  const auto recording = read_recording(file);
  if (!recording) return recording.error();
  auto rules = load_rules(recording->rules, nullptr, recording->player);
  if (!rules) return rules.error();
  if (recording->controls.empty()) return bad_input(file.string() + ": the match has no ticks to film");
  const MatchSetup setup{*rules, recording->seed, recording->difficulty};
  const auto moment = best_moment(setup, recording->controls, progress);
  if (!moment) return cancelled();
  KERF_ASSERT(moment->from <= moment->to && moment->to <= recording->controls.size());
  auto frames = MatchFrames::open(format.folder, format.width, format.height);
  if (!frames) return frames.error();
  const auto match = match_at(setup, moment->start, recording->controls, moment->from);
  ReplayCamera camera(moment->vehicle, 0);
  frames->picture.show(*match);
  const Ticks ticks = moment->to - moment->from;
  for (Ticks t = 0; t < ticks; ++t) {
    if (!progress.report(static_cast<double>(t) / static_cast<double>(ticks))) return cancelled();
    match->tick(recording->controls[moment->from + t]);
    frames->picture.follow(*match);
    frames->picture.advance(*match, kTick);
    camera.follow(*match, kTick);
    if (static_cast<double>(frames->taken) > seconds_of_ticks(t) * format.frames_per_second) continue;
    const CameraView view = camera.view(frames->aspect(), kFilmFieldOfView);
    if (const Status taken = frames->take(*match, view); !taken) return taken;
  }
  return Done{};
}

namespace {

constexpr double kTraversal = 6, kAfterTraversal = 1.5;  // s
constexpr double kTurnOfLight = 8;                       // s

// Films a static world. Calls `draw` with the elapsed fraction of the film, 0 to 1.
Status film_still(const FilmFormat& format, double seconds, const Progress& progress,
                  const OffscreenRenderer& renderer, const std::function<void(double)>& draw) {
  KERF_ASSERT(format.frames_per_second > 0);
  const auto frames = static_cast<size_t>(std::lround(seconds * format.frames_per_second));
  for (size_t i = 0; i < frames; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(frames);
    if (!progress.report(share)) return cancelled();
    draw(share);
    if (const Status written = renderer.write(frame_file(format.folder, i)); !written) return written;
  }
  return Done{};
}

Result<RenderedImage> draw_first(const std::filesystem::path& file, const FilmFormat& format) {
  auto work = open_file(file);
  if (!work) return work.error();
  const auto options = options_for(file, work->scene, format.width, format.height);
  if (!options) return options.error();
  return draw_picture(std::move(*work), *options);
}

}  // namespace

Status film_graph(const std::filesystem::path& work, const FilmFormat& format, const Progress& progress) {
  const auto picture = draw_first(work, format);
  if (!picture) return picture.error();
  const auto whole = graph_around_last_cut(*picture->document);
  if (!whole) return bad_input(work.string() + ": all faces were removed, so there is no graph to film");
  OffscreenRenderer& renderer = *picture->renderer;
  return film_still(format, kTraversal + kAfterTraversal, progress, renderer, [&](double share) {
    const double done = std::min(1.0, share * (kTraversal + kAfterTraversal) / kTraversal);
    auto drawn = std::make_shared<DrawnGraph>(*whole);
    drawn->marked = static_cast<size_t>(std::lround(done * static_cast<double>(whole->reached)));
    renderer.look().graph = std::move(drawn);
    renderer.draw(picture->document->world(), std::nullopt);
  });
}

Status film_shadow(const std::filesystem::path& scene, const FilmFormat& format, const Progress& progress) {
  const auto picture = draw_first(scene, format);
  if (!picture) return picture.error();
  OffscreenRenderer& renderer = *picture->renderer;
  KERF_ASSERT(!renderer.look().lights.empty());
  const Vec3 first = renderer.look().lights[0].at;
  return film_still(format, kTurnOfLight, progress, renderer, [&](double share) {
    renderer.look().lights[0].at = axis_angle({0, 1, 0}, share * 2 * kPi) * first;
    renderer.draw(picture->document->world(), std::nullopt);
  });
}

}  // namespace kerf
