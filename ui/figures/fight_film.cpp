#include "core/base/assert.h"
#include "core/base/tick.h"
#include "core/game/match/recording.h"
#include "core/game/match/score_log.h"
#include "ui/figures/figure_films.h"
#include "ui/game/match_picture.h"
#include "ui/game/replay_camera.h"
#include "ui/gl/offscreen_context.h"
#include "ui/render/picture/frame_file.h"
#include "ui/render/picture/png.h"

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

// Draws frames of a match.
struct FightStudio {
  const FilmFormat& format;
  MatchPicture picture;
  ReplayCamera camera;
  gl::Framebuffer frame;
  size_t frames = 0;

  void follow(const Match& match) {
    picture.follow(match);
    picture.advance(match, kTick);
    camera.follow(match, kTick);
  }
  Status take(const Match& match) {
    const double aspect = static_cast<double>(format.width) / format.height;
    picture.draw(match, camera.view(aspect, kFilmFieldOfView),
                 {frame.name(), 0, 0, format.width, format.height}, PicturePreset::kHigh);
    return write_png(read_pixels(frame.name(), format.width, format.height),
                     frame_file(format.folder, frames++));
  }
};

}  // namespace

Status film_fight(const std::filesystem::path& file, const FilmFormat& format, const Progress& progress) {
  const auto recording = read_recording(file);
  if (!recording) return recording.error();
  auto rules = load_rules(recording->rules);
  if (!rules) return rules.error();
  if (recording->controls.empty())
    return bad_input(file.string() + ": the match has no tick that could be filmed");
  const MatchSetup setup{*rules, recording->seed, recording->difficulty};
  const auto moment = best_moment(setup, recording->controls, progress);
  if (!moment) return cancelled();
  KERF_ASSERT(moment->from <= moment->to && moment->to <= recording->controls.size());
  const auto context = gl::OffscreenContext::create();
  if (!context) return context.error();
  auto picture = MatchPicture::create();
  if (!picture) return picture.error();
  const auto match = match_at(setup, moment->start, recording->controls, moment->from);
  FightStudio studio{format, std::move(*picture), ReplayCamera(moment->vehicle, 0),
                     gl::Framebuffer({format.width, format.height, 1, false})};
  studio.picture.show(*match);
  const Ticks ticks = moment->to - moment->from;
  for (Ticks t = 0; t < ticks; ++t) {
    if (!progress.report(static_cast<double>(t) / static_cast<double>(ticks))) return cancelled();
    match->tick(recording->controls[moment->from + t]);
    studio.follow(*match);
    if (static_cast<double>(studio.frames) > seconds_of_ticks(t) * format.frames_per_second) continue;
    if (const Status taken = studio.take(*match); !taken) return taken;
  }
  return Done{};
}

}  // namespace kerf
