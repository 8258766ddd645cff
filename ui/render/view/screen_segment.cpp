#include "ui/render/view/screen_segment.h"

#include <algorithm>
#include <array>

#include "core/base/assert.h"

namespace kerf {

namespace {

constexpr double kLeastDepth = 1e-4;  // of the focus: nearer to the plane of the eye nothing can be projected

// x and y span the picture from -depth to depth.
struct ClipPoint {
  double x, y, depth;
};

ClipPoint clip_point(const CameraView& view, const Vec3& p) {
  const Vec3 d = p - view.eye;
  return {glm::dot(d, view.right) / (view.tan_half_fov * view.aspect),
          glm::dot(d, view.up) / view.tan_half_fov, view.parallel ? view.focus : glm::dot(d, view.forward)};
}

// Narrows the shares of a segment to those between which a quantity that is linear along it is not negative.
void keep_positive(double at_from, double at_to, Vec2& share) {
  if (at_from < 0 && at_to < 0) share.y = -1;
  if (at_from < 0 && at_to >= 0) share.x = std::max(share.x, at_from / (at_from - at_to));
  if (at_from >= 0 && at_to < 0) share.y = std::min(share.y, at_from / (at_from - at_to));
}

}  // namespace

std::optional<ScreenSegment> on_screen(const CameraView& view, const Vec3& from, const Vec3& to, int width,
                                       int height, double margin) {
  KERF_ASSERT(width > 0 && height > 0);
  const ClipPoint a = clip_point(view, from), b = clip_point(view, to);
  const Vec2 half(0.5 * width, 0.5 * height), limit = (half + margin) / half;
  const double least = kLeastDepth * view.focus;
  Vec2 share(0, 1);
  keep_positive(a.depth - least, b.depth - least, share);
  keep_positive(limit.x * a.depth - a.x, limit.x * b.depth - b.x, share);
  keep_positive(limit.x * a.depth + a.x, limit.x * b.depth + b.x, share);
  keep_positive(limit.y * a.depth - a.y, limit.y * b.depth - b.y, share);
  keep_positive(limit.y * a.depth + a.y, limit.y * b.depth + b.y, share);
  if (!(share.x < share.y)) return std::nullopt;

  ScreenSegment seen;
  seen.share = share;
  const std::array<Vec2*, 2> ends{&seen.from, &seen.to};
  for (int i = 0; i < 2; ++i) {
    const double s = share[i], depth = std::max(a.depth + s * (b.depth - a.depth), least);
    const Vec2 at(a.x + s * (b.x - a.x), a.y + s * (b.y - a.y));
    *ends[i] = half + half * at / depth;
    seen.inverse_depth[i] = 1 / depth;
  }
  return seen;
}

}  // namespace kerf
