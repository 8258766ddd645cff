#include "ui/game/match_film.h"

#include "core/base/angle.h"
#include "core/base/assert.h"
#include "core/base/tick.h"
#include "ui/game/match_picture.h"
#include "ui/gl/offscreen_context.h"
#include "ui/render/picture/frame_file.h"
#include "ui/render/picture/png.h"

namespace kerf {

namespace {

constexpr double kFieldOfView = 55;  // degrees

}  // namespace

struct MatchFilm::Parts {
  gl::OffscreenContext context;
  Options options;
  MatchPicture picture;
  gl::Framebuffer frame;
  GameCamera camera;
  size_t frames = 0;
};

MatchFilm::MatchFilm(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
MatchFilm::~MatchFilm() = default;
MatchFilm::MatchFilm(MatchFilm&&) noexcept = default;

Result<MatchFilm> MatchFilm::begin(const Match& match, const Options& options) {
  KERF_ASSERT(options.frames_per_second > 0);
  auto context = gl::OffscreenContext::create();
  if (!context) return context.error();
  auto picture = MatchPicture::create();
  if (!picture) return picture.error();
  gl::Framebuffer frame({options.width, options.height, 1, false});
  if (!frame.complete())
    return bad_input("--size: this machine draws no pictures of " + std::to_string(options.width) + "x" +
                     std::to_string(options.height));
  auto parts = std::make_unique<Parts>(
      Parts{std::move(*context), options, std::move(*picture), std::move(frame), GameCamera(), 0});
  parts->picture.show(match);
  parts->camera.viewpoint = Viewpoint::kChase;
  return MatchFilm(std::move(parts));
}

Status MatchFilm::follow(const Match& match, const Controls& controls) {
  bool anew = false;
  for (const Event& event : match.events()) anew = anew || event.kind == Event::Kind::kWaveBegins;
  if (anew) {
    parts_->picture.show(match);
  } else {
    parts_->picture.follow(match);
  }
  const Vec3 aim = direction_of(controls.heading * Controls::kAimStep, controls.pitch * Controls::kAimStep);
  parts_->camera.follow(match, aim, kTick);
  parts_->picture.advance(match, kTick);
  const double due = seconds_of_ticks(match.standing().ticks) * parts_->options.frames_per_second;
  while (static_cast<double>(parts_->frames) < due) {
    if (const Status taken = take_picture(match); !taken) return taken;
  }
  return Done{};
}

Status MatchFilm::take_picture(const Match& match) {
  const Options& o = parts_->options;
  const double aspect = static_cast<double>(o.width) / o.height;
  CameraView view = parts_->camera.view(aspect, kFieldOfView);
  if (o.eye && o.target) view = look_at(*o.eye, *o.target, aspect);
  parts_->picture.draw(match, view, {parts_->frame.name(), 0, 0, o.width, o.height}, PicturePreset::kHigh);
  return write_png(read_pixels(parts_->frame.name(), o.width, o.height),
                   frame_file(o.folder, parts_->frames++));
}

}  // namespace kerf
