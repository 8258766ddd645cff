#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>

#include "ui/render/passes/post_processing.h"
#include "ui/render/renderer.h"
#include "ui/window/layout.h"
#include "ui/window/window.h"

namespace kerf {

// What the views that inspect shadows found in the last picture; nothing where it is not known yet.
struct ShadowStatistics {
  std::optional<size_t> differing;  // pixels that two methods draw differently
  double traced = 0;                // share of the picture's pixels whose shadow rays are traced, 0 to 1
  std::optional<size_t> wrong;      // pixels whose traced shadow differs from the drawn one; all are traced
  friend bool operator==(const ShadowStatistics&, const ShadowStatistics&) = default;
};

// How far the tracing has come: "tracing 40 %".
std::string tracing_text(const ShadowStatistics& statistics);

// What has changed in a picture since it was drawn last.
enum class PictureChange {
  kNothing,
  kHeat,  // the heat of faces, which alters their colours and no shadow
  kAll,   // anything
};

// Whether a picture stands still, so that work on it that takes several frames is worth while.
class PictureRest {
 public:
  // To be called once a frame, at a time in seconds of a clock that never goes back.
  void follow(PictureChange change, double now) {
    now_ = now;
    if (change != PictureChange::kNothing) changed_ = now;
    if (change == PictureChange::kAll) moved_ = now;
  }
  // Whether nothing in it has changed for a moment.
  bool rests() const { return now_ - changed_ > kMoment; }
  // Whether nothing but heat has.
  bool shapes_rest() const { return now_ - moved_ > kMoment; }

 private:
  static constexpr double kMoment = 0.15;  // s
  double now_ = 0, changed_ = 0, moved_ = 0;
};

// Draws ray-traced reference shadows over a picture. A part of them is traced in every frame while the
// picture stays the same.
class TracedShadows {
 public:
  // To be called after a picture of the world was drawn to `target`. Starts or continues while the picture is
  // `still`, which says that its shadows will not change, and starts over for a `fresh` one, which may have
  // others. Draws over the target and records its progress in `statistics`.
  void work(const World& world, const ViewOptions& look, Renderer& renderer, const CameraView& view,
            const Target& target, bool fresh, bool still, ShadowStatistics& statistics);

  // Whether tracing is incomplete, or has not begun because the picture was not still.
  bool busy() const { return waits_ || (traced_ && !traced_->done()); }

 private:
  std::optional<ShadowReference> traced_;
  ShadowCounts drawn_;
  bool waits_ = false;  // for a picture that is still
};

// What a picture shows, and its area of the window.
struct Shot {
  const World& world;
  CameraView view;
  const ViewOptions& look;
  std::optional<BeamPicture> beam;
  Area area;
};

// The picture of a world in the window, and of a second one beside it if the picture is split. It is redrawn
// when something in it has changed and shown again otherwise.
//
// Antialiasing is switched off while the picture moves if it would take too long. Once the picture stands
// still it is gathered from several pictures, one a frame (see GatheredPicture), so that the next change is
// never waited for; where that would take seconds it is left out. While nothing but heat changes, the
// gathered picture follows it. While the faces of a scene that was just opened are sent, nothing of it is
// drawn.
class LivePicture {
 public:
  // Fails if a shader is missing or does not compile.
  static Result<LivePicture> create();

  Renderer& first() { return first_.renderer; }
  // The renderer of the second world, which is created at the first call.
  Result<Renderer*> second();

  // The memory of both renderers.
  PictureMemory memory() const;

  // Draws one picture, or two if `second` is not null and second() was called before. Returns whether
  // anything was redrawn; then took() has to be called with the duration of the frame (s).
  bool draw(const Shot& first, const Shot* second, PictureChange change, const Window& window,
            ShadowStatistics& statistics);
  void took(double seconds);
  // Pictures are drafts, without shadows and with one sample a pixel, until the shadow casters of a large
  // scene that was just opened are there.
  void draft(bool wanted) { draft_ = wanted; }
  // Whether the last picture was a draft.
  bool shows_draft() const { return shows_draft_; }
  // Whether another frame is needed although nothing moves.
  bool busy() const {
    return traced_.busy() || is_gathering() || heat_pictures_ > 0 || statistics_new_ ||
           (shows_draft_ && !draft_);
  }
  // The duration of the last frame with a new picture; 0 before the second one, because the first one
  // includes warming up.
  double seconds() const { return seconds_; }
  // Whether the last picture shows a beam that is off by now, so that the picture is out of date.
  bool shows_dead_beam() const { return dead_beam_; }

 private:
  // s; pictures with several samples that take longer are gathered.
  static constexpr double kSlowFrame = 0.030;
  // So many pictures after heat has changed, what is gathered shows no more of how it was.
  static constexpr int kHeatPictures = 4 * GatheredPicture::kPictures;

  // A renderer, and what is gathered of its pictures.
  struct Drawn {
    Renderer renderer;
    GatheredPicture gathered;
  };

  // How the last picture was drawn.
  enum class Quality {
    kRough,     // with one sample per pixel, to be in time
    kFinished,  // as wanted, with several samples or with one
    kGathered,  // of pictures with one sample, perhaps not all of them yet
  };

  static Result<Drawn> make_drawn();
  explicit LivePicture(Drawn first) : first_(std::move(first)) {}

  double rough_seconds() const { return std::min(rough_seconds_[0], rough_seconds_[1]); }
  bool may_gather() const;
  bool follows_heat(PictureChange change) const;
  // Whether more pictures are to be gathered; it ends early where one of them takes too long.
  bool is_gathering() const {
    return quality_ == Quality::kGathered && !first_.gathered.complete() && may_gather();
  }
  bool draw_shots(const Shot& first, const Shot* second, PictureChange change, const Window& window,
                  ShadowStatistics& statistics);
  bool pass_over(const Shot& first, PictureChange change);
  std::optional<size_t> differing_pixels(const Shot& shot) const;
  void draw_anew(const Shot& first, const Shot* second, const Window& window);
  void gather(const Shot& first, const Shot* second, const Window& window);
  bool show_again(Drawn& drawn, const Target& target) const;

  Drawn first_;
  std::optional<Drawn> second_;
  TracedShadows traced_;
  bool beam_shown_ = false;   // in the last picture
  bool passed_over_ = false;  // changes of frames that nobody saw are missing in it
  bool draft_ = false, shows_draft_ = false;
  bool dead_beam_ = false;
  bool warm_ = false;
  Quality quality_ = Quality::kFinished;
  int heat_pictures_ = 0;                 // left to gather since heat changed
  bool antialiased_ = false;              // the last picture has several samples per pixel
  std::optional<double> smooth_seconds_;  // what the last new picture with several samples took
  // The durations of the last two new pictures with one sample; a change may have made one of them slow.
  std::array<double, 2> rough_seconds_{kSlowFrame, kSlowFrame};
  double seconds_ = 0;
  bool statistics_new_ = false;  // of the last picture, so that panels drawn before it do not show them
  PictureRest rest_;
};

}  // namespace kerf
