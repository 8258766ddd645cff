#include "ui/figures/match_figure.h"

#include "core/base/angle.h"
#include "core/base/tick.h"
#include "ui/game/game_camera.h"
#include "ui/game/hud.h"
#include "ui/game/match_picture.h"

namespace kerf {

namespace {

constexpr double kFieldOfView = 62;                 // degrees
constexpr Ticks kRemembered = 4 * kTicksPerSecond;  // of sparks, scorches and lines of the display

Vec3 aim_of(const Controls& c) {
  return direction_of(c.heading * Controls::kAimStep, c.pitch * Controls::kAimStep);
}

// What the screen of a match remembers of its last seconds.
struct MatchScreen {
  MatchPicture picture;
  GameCamera camera;
  HudState hud;

  void follow(const Match& match, const Controls& controls, bool first) {
    bool anew = first;
    for (const Event& event : match.events()) anew = anew || event.kind == Event::Kind::kWaveBegins;
    if (anew) {
      picture.show(match);
    } else {
      picture.follow(match);
    }
    hud.hear(match);
    hud.advance(kTick);
    picture.advance(match, kTick);
    camera.follow(match, aim_of(controls), kTick);
  }
};

}  // namespace

Status draw_match_figure(const std::filesystem::path& file, Ticks tick, const gl::Framebuffer& picture,
                         OffscreenGui& gui) {
  const auto recording = read_recording(file);
  if (!recording) return recording.error();
  if (tick == 0 || recording->controls.size() < tick)
    return bad_input(file.string() + ": the match has " + std::to_string(recording->controls.size()) +
                     " ticks, and the figure wants the one after " + std::to_string(tick));
  auto rules = load_rules(recording->rules);
  if (!rules) return rules.error();
  auto drawn = MatchPicture::create();
  if (!drawn) return drawn.error();
  MatchScreen screen{std::move(*drawn), {}, {}};
  Match match({*rules, recording->seed, recording->difficulty});
  const Ticks begins = tick - std::min(tick, kRemembered);
  for (Ticks t = 0; t < tick; ++t) {
    match.tick(recording->controls[t]);
    if (t >= begins) screen.follow(match, recording->controls[t], t == begins);
  }
  const Controls& last = recording->controls[tick - 1];
  const gl::Framebuffer::Shape& shape = picture.shape();
  const CameraView view = screen.camera.view(static_cast<double>(shape.width) / shape.height, kFieldOfView);
  screen.picture.draw(match, view, {picture.name(), 0, 0, shape.width, shape.height}, PicturePreset::kHigh);
  const double width = static_cast<double>(last.width) / Controls::kFull;
  gui.draw(picture, [&] { draw_hud({match, screen.hud, view, aim_of(last), width, false}); });
  return Done{};
}

}  // namespace kerf
