#pragma once

#include <chrono>
#include <optional>

#include "ui/editor/editor_state.h"
#include "ui/render/renderer.h"
#include "ui/screen/traced_shadows.h"
#include "ui/window/window.h"

namespace kerf {

// The picture of the world in the window, and of its twin beside it where it is split: drawn anew when
// something in it has changed, handed over once more otherwise. While it moves it is drawn without smooth
// edges where those would take too long.
class LivePicture {
 public:
  explicit LivePicture(Renderer renderer) : first_(std::move(renderer)) {}

  // Of the document's world.
  Renderer& first() { return first_; }
  // Of its twin's; made when it is first asked for.
  Result<Renderer*> second();

  // Of both.
  PictureMemory memory() const;

  // Whether anything was drawn anew; then took() wants to know how long the frame took (s).
  bool draw(EditorState& state, const Window& window);
  void took(double seconds);
  // Whether there is more to draw although nothing moves.
  bool busy() const { return traced_.busy(); }
  // What the last frame with a new picture took; 0 before the second one, for the first also warms up.
  double seconds() const { return seconds_; }

 private:
  using Clock = std::chrono::steady_clock;
  void draw_anew(EditorState& state, const Window& window, bool still);

  Renderer first_;
  std::optional<Renderer> second_;
  TracedShadows traced_;
  bool beam_shown_ = false;  // in the last picture
  bool rough_ = false;       // the last picture was drawn without smooth edges to be in time
  bool antialiased_ = false;
  bool warm_ = false;
  double smooth_seconds_ = 0;  // what the last smooth frame with a new picture took
  double seconds_ = 0;
  Clock::time_point moved_at_{};
};

// Where a rectangle of the window lies in its framebuffer, from the upper left corner; whole pixels.
Area pixels_of(const Area& area, const Window& window);

}  // namespace kerf
