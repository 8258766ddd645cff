#pragma once

#include <algorithm>
#include <array>
#include <optional>

#include "ui/render/passes/post_processing.h"
#include "ui/render/renderer.h"
#include "ui/window/layout.h"
#include "ui/window/window.h"

namespace kerf {

// Results of the shadow inspection views for the last frame; nullopt: not known yet.
struct ShadowStatistics {
  std::optional<size_t> differing;  // pixels that two methods draw differently
  double traced = 0;                // fraction of the frame's pixels whose shadow rays are traced, 0 to 1
  std::optional<size_t> wrong;  // pixels whose traced shadow differs from the drawn one, once all are traced
  friend bool operator==(const ShadowStatistics&, const ShadowStatistics&) = default;
};

// The progress of the tracing: "tracing 40 %".
std::string tracing_text(const ShadowStatistics& statistics);

// The change in the viewport since the last frame.
enum class PictureChange {
  kNothing,
  kHeat,  // the heat of faces, which changes colours but no shadows
  kAll,   // anything
};

// Detects a static viewport, in which work over several frames pays off.
class PictureRest {
 public:
  // Must be called once per frame, with the time in seconds of a monotonic clock.
  void follow(PictureChange change, double now) {
    now_ = now;
    if (change != PictureChange::kNothing) changed_ = now;
    if (change == PictureChange::kAll) moved_ = now;
  }
  // Returns true if nothing has changed for a moment.
  bool rests() const { return now_ - changed_ > kMoment; }
  // Returns true if nothing except heat has changed for a moment.
  bool shapes_rest() const { return now_ - moved_ > kMoment; }

 private:
  static constexpr double kMoment = 0.15;  // s
  double now_ = 0, changed_ = 0, moved_ = 0;
};

// Draws ray-traced reference shadows over the viewport, a part per frame while it stays static.
class TracedShadows {
 public:
  // Must be called after the world was drawn to `target`. Starts or continues while the viewport is
  // `still`, i.e. its shadows will not change, and restarts for a `fresh` frame, whose shadows may differ.
  // Draws over the target and writes its progress to `statistics`.
  void work(const World& world, const ViewOptions& look, Renderer& renderer, const CameraView& view,
            const Target& target, bool fresh, bool still, ShadowStatistics& statistics);

  // Returns true if tracing is incomplete, or waits for a static viewport.
  bool busy() const { return waits_ || (traced_ && !traced_->done()); }

 private:
  std::optional<ShadowReference> traced_;
  ShadowCounts drawn_;
  bool waits_ = false;  // for a static viewport
};

struct Shot {
  const World& world;
  CameraView view;
  const ViewOptions& look;
  std::optional<BeamPicture> beam;
  Area area;
};

// The viewport of a world, and a second one next to it if the view is split. Redraws on changes; otherwise
// shows the last frame again.
//
// While the view moves, disables antialiasing if it is too slow. A static view accumulates samples over
// several frames (see GatheredPicture), unless that would take seconds; heat changes update the accumulated
// image. A large new scene appears at once, as a draft of the faces that are uploaded so far, so that no
// earlier scene stands under its counts.
class LivePicture {
 public:
  // Fails if a shader is missing or does not compile.
  static Result<LivePicture> create();

  Renderer& first() { return first_.renderer; }
  // Returns the renderer of the second world, which the first call creates.
  Result<Renderer*> second();

  PictureMemory memory() const;

  // Draws one viewport, or two if `second` is not null; then second() must have been called before. Returns
  // true if anything was redrawn; took() must then be called with the duration of the frame [s].
  bool draw(const Shot& first, const Shot* second, PictureChange change, const Window& window,
            ShadowStatistics& statistics);
  void took(double seconds);
  // Draws drafts, without shadows and with one sample per pixel, until the shadow casters of a large, newly
  // opened scene are ready.
  void draft(bool wanted) { draft_ = wanted; }
  bool shows_draft() const { return shows_draft_; }
  // Returns true if another frame is needed although nothing moves.
  bool busy() const {
    return traced_.busy() || is_gathering() || heat_pictures_ > 0 || statistics_new_ ||
           (shows_draft_ && !draft_);
  }
  // The duration of the last new frame [s]; 0 before the second one, because the first includes warming up.
  double seconds() const { return seconds_; }
  // Returns true if the last frame is outdated because it shows a beam that is now off.
  bool shows_dead_beam() const { return dead_beam_; }

 private:
  // s; slower frames with several samples are accumulated instead.
  static constexpr double kSlowFrame = 0.030;
  // Frames after a change of heat until the accumulated frame shows none of the earlier heat.
  static constexpr int kHeatPictures = 4 * GatheredPicture::kPictures;

  struct Drawn {
    Renderer renderer;
    GatheredPicture gathered;
  };

  enum class Quality {
    kRough,     // with one sample per pixel, to be in time
    kFinished,  // as requested, with several samples or one
    kGathered,  // accumulated from frames with one sample, perhaps incomplete
  };

  static Result<Drawn> make_drawn();
  explicit LivePicture(Drawn first) : first_(std::move(first)) {}

  double rough_seconds() const { return std::min(rough_seconds_[0], rough_seconds_[1]); }
  bool may_gather() const;
  bool follows_heat(PictureChange change) const;
  // Returns true if more frames are to be accumulated. Stops accumulating early if single frames take too
  // long.
  bool is_gathering() const {
    return quality_ == Quality::kGathered && !first_.gathered.complete() && may_gather();
  }
  bool draw_shots(const Shot& first, const Shot* second, PictureChange change, const Window& window,
                  ShadowStatistics& statistics);
  bool draw_part(const Shot& first, const Window& window);
  bool pass_over(const Shot& first, PictureChange change);
  std::optional<size_t> differing_pixels(const Shot& shot) const;
  void redraw(const Shot& first, const Shot* second, const Window& window);
  void gather(const Shot& first, const Shot* second, const Window& window);
  bool show_again(Drawn& drawn, const Target& target) const;

  Drawn first_;
  std::optional<Drawn> second_;
  TracedShadows traced_;
  bool beam_shown_ = false;   // in the last frame
  bool passed_over_ = false;  // lacks changes of frames that were not drawn
  bool draft_ = false, shows_draft_ = false;
  bool sends_ = false;    // faces were left to upload in the last frame
  double next_part_ = 0;  // s of the clock, of the next draft during the upload
  bool dead_beam_ = false;
  bool warm_ = false;
  Quality quality_ = Quality::kFinished;
  int heat_pictures_ = 0;                 // left to accumulate since heat changed
  bool antialiased_ = false;              // the last frame has several samples per pixel
  std::optional<double> smooth_seconds_;  // duration of the last new frame with several samples
  // The durations of the last two new frames with one sample; a change may have slowed one of them down.
  std::array<double, 2> rough_seconds_{kSlowFrame, kSlowFrame};
  double seconds_ = 0;
  bool statistics_new_ = false;  // panels drawn before the last frame do not show its statistics
  PictureRest rest_;
};

}  // namespace kerf
