#include "core/base/assert.h"
#include "core/base/tick.h"
#include "core/game/match/recording.h"
#include "core/game/match/score_log.h"
#include "ui/figures/figure_films.h"
#include "ui/game/match_film.h"
#include "ui/game/replay_camera.h"

namespace kerf {

namespace {

constexpr double kFilmFieldOfView = 45;  // degrees

// The best moment of a match; nothing if `progress` stopped the search.
std::optional<MatchMoment> best_moment(const MatchSetup& setup, const std::vector<Controls>& controls,
                                       const Progress& progress) {
  ScoreLog log;
  Match match(setup);
  for (const Controls& c : controls) {
    if (!progress.report(0)) return std::nullopt;
    match.tick(c);
    log.hear(match);
  }
  return log.best();
}

}  // namespace

Status film_fight(const std::filesystem::path& file, const FilmFormat& format, const Progress& progress) {
  const auto recording = read_recording(file);
  if (!recording) return recording.error();
  auto rules = load_rules(recording->rules, nullptr, recording->player);
  if (!rules) return rules.error();
  if (recording->controls.empty())
    return bad_input(file.string() + ": the match has no tick that could be filmed");
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

}  // namespace kerf
