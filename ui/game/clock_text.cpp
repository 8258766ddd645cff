#include "ui/game/clock_text.h"

#include <algorithm>
#include <cstdio>

namespace kerf {

std::string clock_text(double seconds) {
  char text[32];
  const int whole = static_cast<int>(std::max(0.0, seconds));
  std::snprintf(text, sizeof text, "%d:%02d", whole / 60, whole % 60);
  return text;
}

}  // namespace kerf
