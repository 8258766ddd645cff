#pragma once

#include <chrono>
#include <optional>

#include "ui/render/renderer.h"
#include "ui/screen/shadow_figures.h"
#include "ui/screen/traced_shadows.h"
#include "ui/window/layout.h"
#include "ui/window/window.h"

namespace kerf {

// What a picture shows, and its area of the window.
struct Shot {
  const World& world;
  CameraView view;
  const ViewOptions& look;
  std::optional<BeamPicture> beam;
  Area area;
};

// The picture of a world in the window, and of a second one beside it if the picture is split. It is redrawn
// when something in it has changed and shown again otherwise. While it moves, antialiasing is switched off if
// it would take too long.
class LivePicture {
 public:
  explicit LivePicture(Renderer renderer) : first_(std::move(renderer)) {}

  Renderer& first() { return first_; }
  // The renderer of the second world, which is created at the first call.
  Result<Renderer*> second();

  // The memory of both renderers.
  PictureMemory memory() const;

  // Draws one picture, or two if `second` is not null and second() was called before. `old` says that
  // something in them has changed. Returns whether anything was redrawn; then took() has to be called with
  // the duration of the frame (s).
  bool draw(const Shot& first, const Shot* second, bool old, const Window& window, ShadowFigures& figures);
  void took(double seconds);
  // Whether another frame is needed although nothing moves.
  bool busy() const { return traced_.busy(); }
  // The duration of the last frame with a new picture; 0 before the second one, because the first one
  // includes warming up.
  double seconds() const { return seconds_; }
  // Whether the last picture shows a beam that is off by now, so that the picture is out of date.
  bool shows_dead_beam() const { return dead_beam_; }

 private:
  using Clock = std::chrono::steady_clock;
  void draw_anew(const Shot& first, const Shot* second, const Window& window, bool still);
  void draw_shot(Renderer& renderer, const Shot& shot, const Window& window) const;

  Renderer first_;
  std::optional<Renderer> second_;
  TracedShadows traced_;
  bool beam_shown_ = false;  // in the last picture
  bool dead_beam_ = false;
  bool rough_ = false;  // the last picture was drawn without smooth edges to be in time
  bool antialiased_ = false;
  bool warm_ = false;
  double smooth_seconds_ = 0;  // what the last smooth frame with a new picture took
  double seconds_ = 0;
  Clock::time_point moved_at_{};
};

}  // namespace kerf
