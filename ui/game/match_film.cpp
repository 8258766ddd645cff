#include "ui/game/match_film.h"

#include "core/base/assert.h"
#include "core/base/tick.h"
#include "ui/render/picture/png.h"

namespace kerf {

namespace {

constexpr double kFilmedView = 55;  // degrees

}  // namespace

Result<MatchFrames> MatchFrames::open(const std::filesystem::path& folder, int width, int height) {
  auto context = gl::OffscreenContext::create();
  if (!context) return context.error();
  auto picture = MatchPicture::create();
  if (!picture) return picture.error();
  gl::Framebuffer frame({width, height, 1, false});
  if (!frame.complete())
    return bad_input("--size: this machine draws no pictures of " + std::to_string(width) + "x" +
                     std::to_string(height));
  return MatchFrames{std::move(*context), std::move(*picture), std::move(frame), folder};
}

Status MatchFrames::take(const Match& match, const CameraView& view) {
  const int width = frame.shape().width, height = frame.shape().height;
  picture.draw(match, view, {frame.name(), 0, 0, width, height}, PicturePreset::kHigh);
  return write_png(read_pixels(frame.name(), width, height), frame_file(folder, taken++));
}

MatchFilm::MatchFilm(MatchFrames frames, const Options& options)
    : frames_(std::move(frames)), options_(options) {
  camera_.viewpoint = Viewpoint::kChase;
}

Result<MatchFilm> MatchFilm::begin(const Match& match, const Options& options) {
  KERF_ASSERT(options.frames_per_second > 0);
  auto frames = MatchFrames::open(options.folder, options.width, options.height);
  if (!frames) return frames.error();
  frames->picture.show(match);
  return MatchFilm(std::move(*frames), options);
}

Status MatchFilm::follow(const Match& match, const Controls& controls) {
  frames_.picture.follow(match);
  camera_.follow(match, aim_of(controls), kTick);
  frames_.picture.advance(match, kTick);
  const double due = seconds_of_ticks(match.standing().elapsed()) * options_.frames_per_second;
  while (static_cast<double>(frames_.taken) < due) {
    CameraView view = camera_.view(frames_.aspect(), kFilmedView);
    if (options_.eye && options_.target) view = look_at(*options_.eye, *options_.target, frames_.aspect());
    if (const Status taken = frames_.take(match, view); !taken) return taken;
  }
  return Done{};
}

}  // namespace kerf
