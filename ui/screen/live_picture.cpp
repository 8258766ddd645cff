#include "ui/screen/live_picture.h"

namespace kerf {

namespace {

constexpr double kSlowFrame = 0.030;  // s; smooth pictures that take longer are left for when nothing moves
constexpr double kStillSeconds = 0.15;

Target target_of(const Area& area, const Window& window) {
  const Area pixels = pixels_of(area, window);
  return {0, static_cast<int>(pixels.at.x),
          static_cast<int>(window.pixel_size().y - pixels.at.y - pixels.size.y),
          static_cast<int>(pixels.size.x), static_cast<int>(pixels.size.y)};
}

}  // namespace

Result<Renderer*> LivePicture::second() {
  if (!second_) {
    auto made = Renderer::create();
    if (!made) return made.error();
    second_ = std::move(*made);
  }
  return &*second_;
}

PictureMemory LivePicture::memory() const {
  PictureMemory memory = first_.memory();
  if (second_) memory += second_->memory();
  return memory;
}

bool LivePicture::draw(const Shot& first, const Shot* second, bool old, const Window& window,
                       ShadowFigures& figures) {
  if (!second_) second = nullptr;
  if (old) moved_at_ = Clock::now();
  const bool still = std::chrono::duration<double>(Clock::now() - moved_at_).count() > kStillSeconds;
  const Target target = target_of(first.area, window);
  const bool anew = old || (rough_ && still) || !first_.draw_again(target) ||
                    (second != nullptr && !second_->draw_again(target_of(second->area, window)));
  if (anew) draw_anew(first, second, window, still);
  if (anew && first.look.show.shadow_compare) figures.differing = first_.differing_pixels();
  traced_.work(first.world, first.look, first_, first.view, target, anew, still, figures);
  dead_beam_ = beam_shown_ && !first.beam;
  return anew;
}

void LivePicture::draw_anew(const Shot& first, const Shot* second, const Window& window, bool still) {
  rough_ = first.look.antialias && !still && smooth_seconds_ > kSlowFrame;
  antialiased_ = first.look.antialias && !rough_;
  beam_shown_ = first.beam.has_value();
  draw_shot(first_, first, window);
  if (second != nullptr) draw_shot(*second_, *second, window);
}

void LivePicture::draw_shot(Renderer& renderer, const Shot& shot, const Window& window) const {
  ViewOptions look = shot.look;
  look.antialias = antialiased_;
  renderer.draw(shot.world, shot.view, look, shot.beam, target_of(shot.area, window));
}

void LivePicture::took(double seconds) {
  if (antialiased_) smooth_seconds_ = seconds;
  if (warm_) seconds_ = seconds;
  warm_ = true;
}

}  // namespace kerf
