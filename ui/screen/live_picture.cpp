#include "ui/screen/live_picture.h"

#include <utility>

#include "ui/gl/program.h"
#include "ui/window/number_text.h"

namespace kerf {

namespace {
constexpr size_t kPixelsOfFrame = 6000;

constexpr double kSamplesCost = 4;                     // maximum slowdown by several samples
constexpr double kMaxGathered = 0.4;                   // s; maximum duration of an accumulated frame
constexpr double kBetweenParts = 0.2, kPartShare = 4;  // s, and durations of a part, between parts of a scene

Target target_of(const Area& area, const Window& window) {
  const Area pixels = pixels_of(area, window);
  return {0, static_cast<int>(pixels.at.x),
          static_cast<int>(window.pixel_size().y - pixels.at.y - pixels.size.y),
          static_cast<int>(pixels.size.x), static_cast<int>(pixels.size.y)};
}

// Leaves out everything that needs shadow casters.
void omit_shadows(ShowOptions& show) {
  show.shadows = Shadows::kNone;
  show.silhouette = show.shadow_volumes = show.shadow_stencil = false;
  show.shadow_facing = show.shadow_compare = false;
}

// Fills a part of the window with the colour behind the panels' edges.
void clear(const Target& target) {
  glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
  gl::fill(target.x, target.y, target.width, target.height, {0.035f, 0.040f, 0.048f, 1});
}

}  // namespace

std::string tracing_text(const ShadowStatistics& statistics) {
  KERF_ASSERT(statistics.traced >= 0 && statistics.traced <= 1);
  return text_of("tracing %.0f %%", 100 * statistics.traced);
}

void TracedShadows::work(const World& world, const ViewOptions& look, Renderer& renderer,
                         const CameraView& view, const Target& target, bool fresh, bool still,
                         ShadowStatistics& statistics) {
  const bool wanted = look.show.shadow_reference && look.shadow.inspected < look.lights.size();
  if (!wanted || fresh) traced_.reset();
  if (wanted && still && !traced_) {
    traced_ = renderer.shadow_reference(world, view, look, look.shadow.inspected, true, target.width,
                                        target.height);
    drawn_ = renderer.shadow_counts(world, view, look, look.shadow.inspected, look.shadow.method, true,
                                    target.width, target.height);
  }
  waits_ = wanted && !traced_;
  statistics.traced = 0;
  statistics.wrong.reset();
  if (look.show.shadow_reference && look.lights.empty()) statistics.wrong = 0;
  if (!traced_) return;
  if (still) traced_->trace(kPixelsOfFrame);
  renderer.draw_reference(*traced_, drawn_, target);
  statistics.traced = traced_->share_done();
  if (traced_->done()) statistics.wrong = differing_pixels(drawn_, *traced_);
}

Result<LivePicture::Drawn> LivePicture::make_drawn() {
  auto renderer = Renderer::create();
  if (!renderer) return renderer.error();
  Shaders shaders;
  GatheredPicture gathered(shaders);
  if (!shaders.status()) return shaders.status().error();
  return Drawn{std::move(*renderer), std::move(gathered)};
}

Result<LivePicture> LivePicture::create() {
  auto first = make_drawn();
  if (!first) return first.error();
  return LivePicture(std::move(*first));
}

Result<Renderer*> LivePicture::second() {
  if (!second_) {
    auto made = make_drawn();
    if (!made) return made.error();
    second_.emplace(std::move(*made));
  }
  return &second_->renderer;
}

PictureMemory LivePicture::memory() const {
  PictureMemory memory = first_.renderer.memory();
  if (second_) memory += second_->renderer.memory();
  return memory;
}

bool LivePicture::draw(const Shot& first, const Shot* second, PictureChange change, const Window& window,
                       ShadowStatistics& statistics) {
  const ShadowStatistics before = statistics;
  const bool drawn = draw_shots(first, second, change, window, statistics);
  statistics_new_ = statistics != before;
  return drawn;
}

bool LivePicture::draw_shots(const Shot& first, const Shot* second, PictureChange change,
                             const Window& window, ShadowStatistics& statistics) {
  if (!second_) second = nullptr;
  const Target target = target_of(first.area, window);
  const bool was_sending = std::exchange(sends_, first_.renderer.is_sending());
  if (sends_) {
    if (!was_sending) next_part_ = 0;
    if (!draw_part(first, window) && !show_again(first_, target)) clear(target);
    return false;
  }
  rest_.follow(change, window.clock().seconds());
  if (!window.draws() && !first.look.show.shadow_compare) return pass_over(first, change);
  const bool heat = follows_heat(change);
  if (heat) heat_pictures_ = kHeatPictures;
  const bool was_passed_over = std::exchange(passed_over_, false), was_draft = shows_draft_ && !draft_;
  const bool old = (change != PictureChange::kNothing && !heat) || was_passed_over || was_draft;
  if (old) heat_pictures_ = 0;
  const bool more =
      !old && ((rest_.rests() && (is_gathering() || (quality_ == Quality::kRough && may_gather()))) ||
               heat_pictures_ > 0);
  const bool redrawn =
      old || (!more && (!show_again(first_, target) ||
                        (second != nullptr && !show_again(*second_, target_of(second->area, window)))));
  if (redrawn) redraw(first, second, window);
  if (more) gather(first, second, window);
  if (redrawn) statistics.differing = differing_pixels(first);
  traced_.work(first.world, first.look, first_.renderer, first.view, target,
               redrawn && change != PictureChange::kHeat, rest_.shapes_rest() && !is_gathering() && !draft_,
               statistics);
  dead_beam_ = beam_shown_ && !first.beam;
  return redrawn || more;
}

// Draws the faces of a new scene that are uploaded so far, if it is time to. Without shadows, which need all.
bool LivePicture::draw_part(const Shot& first, const Window& window) {
  const double began = window.clock().seconds();
  if (!draft_ || !window.draws() || began < next_part_) return false;
  redraw(first, nullptr, window);
  shows_draft_ = false;
  const double ended = window.clock().seconds();
  next_part_ = ended + std::max(kBetweenParts, kPartShare * (ended - began));
  return true;
}

// Returns true if the change is accumulated into the static frame.
bool LivePicture::follows_heat(PictureChange change) const {
  return change == PictureChange::kHeat && rest_.shapes_rest() && !passed_over_ &&
         quality_ != Quality::kFinished && may_gather();
}

bool LivePicture::pass_over(const Shot& first, PictureChange change) {
  const bool changed = change != PictureChange::kNothing;
  passed_over_ = passed_over_ || changed;
  if (changed) beam_shown_ = first.beam.has_value();
  dead_beam_ = beam_shown_ && !first.beam;
  return changed;
}

std::optional<size_t> LivePicture::differing_pixels(const Shot& shot) const {
  if (draft_ || !shot.look.show.shadow_compare) return std::nullopt;
  return first_.renderer.differing_pixels();
}

bool LivePicture::may_gather() const { return !draft_ && rough_seconds() <= kMaxGathered; }

bool LivePicture::show_again(Drawn& drawn, const Target& target) const {
  if (quality_ != Quality::kGathered) return drawn.renderer.draw_again(target);
  if (!drawn.gathered.can_show(target)) return false;
  drawn.gathered.show(target);
  return true;
}

void LivePicture::redraw(const Shot& first, const Shot* second, const Window& window) {
  const bool draft = draft_;
  if (draft) {  // the durations of earlier frames do not predict this one
    smooth_seconds_.reset();
    rough_seconds_ = {kSlowFrame, kSlowFrame};
  }
  shows_draft_ = draft;
  const double expected = smooth_seconds_ ? *smooth_seconds_ : kSamplesCost * rough_seconds();
  antialiased_ = first.look.antialias && expected <= kSlowFrame;
  quality_ = first.look.antialias && !antialiased_ ? Quality::kRough : Quality::kFinished;
  beam_shown_ = first.beam.has_value();
  const auto draw = [&](Drawn& drawn, const Shot& shot) {
    ViewOptions look = shot.look;
    look.antialias = antialiased_;
    if (draft) omit_shadows(look.show);
    drawn.renderer.draw(shot.world, shot.view, look, shot.beam, target_of(shot.area, window));
  };
  draw(first_, first);
  if (second != nullptr) draw(*second_, *second);
}

void LivePicture::gather(const Shot& first, const Shot* second, const Window& window) {
  const bool begins = quality_ != Quality::kGathered;
  if (heat_pictures_ > 0) --heat_pictures_;
  quality_ = Quality::kGathered;
  const auto add = [&](Drawn& drawn, const Shot& shot) {
    const Target target = target_of(shot.area, window);
    if (begins || !drawn.gathered.can_show(target)) drawn.gathered.begin(target.width, target.height);
    ViewOptions look = shot.look;
    look.antialias = false;
    drawn.gathered.add(
        [&](const Target& next) { drawn.renderer.draw(shot.world, shot.view, look, shot.beam, next); });
    drawn.gathered.show(target);
  };
  add(first_, first);
  if (second != nullptr) add(*second_, *second);
}

void LivePicture::took(double seconds) {
  if (!std::exchange(warm_, true)) return;
  seconds_ = seconds;
  if (antialiased_ && quality_ == Quality::kFinished) {
    smooth_seconds_ = seconds;
  } else {
    rough_seconds_ = {rough_seconds_[1], seconds};
    if (kSamplesCost * rough_seconds() <= kSlowFrame) smooth_seconds_.reset();
  }
}

}  // namespace kerf
