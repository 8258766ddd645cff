#include "ui/screen/live_picture.h"

#include "ui/editor/tools/piece_set.h"

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

CameraView view_in(const Area& area, const Camera& camera) { return camera.view(area.size.x / area.size.y); }

// What was chosen or hidden are pieces of the first world; those of the twin are others.
void look_at_twin(const EditorState& state, ViewOptions& look) {
  look.pieces.clear();
  if (state.spread > 0) spread_pieces(state.split.twin.world(), state.spread, look.pieces);
}

}  // namespace

Area pixels_of(const Area& area, const Window& window) {
  const Vec2 scale = window.pixel_size() / window.size();
  const Vec2 from = glm::floor(area.at * scale), to = glm::floor((area.at + area.size) * scale);
  return {from, glm::max(Vec2(1), to - from)};
}

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

bool LivePicture::draw(EditorState& state, const Window& window) {
  if (state.picture_old) moved_at_ = Clock::now();
  const bool still = std::chrono::duration<double>(Clock::now() - moved_at_).count() > kStillSeconds;
  const Layout& layout = state.layout;
  const bool split = layout.split() && second_;
  const bool anew = state.picture_old || (rough_ && still) ||
                    !first_.draw_again(target_of(layout.first, window)) ||
                    (split && !second_->draw_again(target_of(layout.second, window)));
  if (anew) draw_anew(state, window, still);
  traced_.work(state, first_, view_in(layout.first, state.camera), target_of(layout.first, window), anew,
               still);
  // Once more without the beam when it is off.
  state.picture_old = beam_shown_ && !state.tool.picture(state.document);
  return anew;
}

void LivePicture::draw_anew(EditorState& state, const Window& window, bool still) {
  ViewOptions look = state.look;
  look.tree.palette = state.settings.palette;
  rough_ = look.antialias && !still && smooth_seconds_ > kSlowFrame;
  if (rough_) look.antialias = false;
  antialiased_ = look.antialias;
  const Layout& layout = state.layout;
  const std::optional<BeamPicture> beam = state.tool.picture(state.document);
  first_.draw(state.document.world(), view_in(layout.first, state.camera), look, beam,
              target_of(layout.first, window));
  beam_shown_ = beam.has_value();
  if (look.show.shadow_compare) state.shadow_figures.differing = first_.differing_pixels();
  if (!layout.split() || !second_) return;
  look_at_twin(state, look);
  second_->draw(state.split.twin.world(), view_in(layout.second, state.camera), look, beam,
                target_of(layout.second, window));
}

void LivePicture::took(double seconds) {
  if (antialiased_) smooth_seconds_ = seconds;
  if (warm_) seconds_ = seconds;
  warm_ = true;
}

}  // namespace kerf
