#pragma once

#include <string>

#include "ui/editor/shared/picture/view_state.h"

namespace kerf {

// The badges of modes that are on, below each other at the upper edge of the first half of the viewport.
class Badges {
 public:
  enum class Sign { kPlaying, kPaused, kMode };

  // To be called once a frame before any is drawn.
  void begin_frame() { drawn_ = 0; }
  // Draws the next one, `least_ems` wide at least, so that it does not change its width with its text. The
  // landmark is its name in tests.
  void draw(const ViewState& view, Sign sign, const std::string& text, const char* landmark,
            float least_ems = 0);

 private:
  int drawn_ = 0;
};

}  // namespace kerf
