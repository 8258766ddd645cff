#include "core/document/text/colour_text.h"

#include <array>
#include <cmath>
#include <cstdio>

#include "core/base/assert.h"

namespace kerf {

namespace {

// The linear value of one of the 256 steps of sRGB (IEC 61966-2-1). Colours do not enter any hash, so that
// pow(), whose results differ between machines, is acceptable.
double linear_of(int step) {
  KERF_ASSERT(step >= 0 && step <= 255);
  const double s = step / 255.0;
  return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
}

int nearest_step(double linear) {
  int step = 0;
  while (step < 255 && linear > 0.5 * (linear_of(step) + linear_of(step + 1))) ++step;
  return step;
}

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

}  // namespace

std::optional<Vec3> parse_colour(std::string_view text) {
  if (text.size() != 7 || text[0] != '#') return std::nullopt;
  Vec3 colour{0};
  for (int channel = 0; channel < 3; ++channel) {
    const int high = hex_digit(text[static_cast<size_t>(1 + 2 * channel)]);
    const int low = hex_digit(text[static_cast<size_t>(2 + 2 * channel)]);
    if (high < 0 || low < 0) return std::nullopt;
    colour[channel] = linear_of(16 * high + low);
  }
  return colour;
}

std::string colour_text(const Vec3& linear) {
  std::array<char, 8> text{};
  std::snprintf(text.data(), text.size(), "#%02x%02x%02x", static_cast<unsigned>(nearest_step(linear.x)),
                static_cast<unsigned>(nearest_step(linear.y)), static_cast<unsigned>(nearest_step(linear.z)));
  return text.data();
}

}  // namespace kerf
