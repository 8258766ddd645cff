#pragma once

#include <chrono>
#include <optional>

#include "ui/render/renderer.h"
#include "ui/screen/shadow_figures.h"
#include "ui/screen/traced_shadows.h"
#include "ui/window/layout.h"
#include "ui/window/window.h"

namespace kerf {

// What a picture shows, and where in the window.
struct Shot {
  const World& world;
  CameraView view;
  const ViewOptions& look;
  std::optional<BeamPicture> beam;
  Area area;
};

// The picture of a world in the window, and of another one beside it where it is split: drawn anew when
// something in it has changed, handed over once more otherwise. While it moves it is drawn without smooth
// edges where those would take too long.
class LivePicture {
 public:
  explicit LivePicture(Renderer renderer) : first_(std::move(renderer)) {}

  Renderer& first() { return first_; }
  // Of the world beside the first; made when it is first asked for.
  Result<Renderer*> second();

  // Of both.
  PictureMemory memory() const;

  // Draws one picture, or two where `second` is not null and second() was asked for; `old` says that
  // something in them has changed. Returns whether anything was drawn anew; then took() wants to know how
  // long the frame took (s).
  bool draw(const Shot& first, const Shot* second, bool old, const Window& window, ShadowFigures& figures);
  void took(double seconds);
  // Whether there is more to draw although nothing moves.
  bool busy() const { return traced_.busy(); }
  // What the last frame with a new picture took; 0 before the second one, for the first also warms up.
  double seconds() const { return seconds_; }
  // Whether the last picture shows a beam that was off when draw() returned, and so is old.
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
