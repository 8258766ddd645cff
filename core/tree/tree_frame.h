#pragma once

#include <smmintrin.h>

#include "core/base/bounds.h"
#include "core/base/vec3.h"

namespace kerf {

// The coordinates of a tree's boxes: (x - origin) * scale, so that a mesh of any size at any place lies
// within about [-1, 1] and the precision of floats suffices for culling.
struct TreeFrame {
  Vec3 origin{0};
  double scale = 1;  // a power of two

  // Returns the frame for faces with these bounds, the identity if there are none.
  static TreeFrame around(const Bounds& bounds);

  Vec3 to_tree(const Vec3& p) const { return (p - origin) * scale; }
  // The point in the frame of the tree, rounded to the nearest floats; the fourth lane is zero.
  __m128 to_floats(const Vec3& point) const {
    const double* p = &point.x;
    const __m128d factor = _mm_set1_pd(scale);
    const __m128d xy = _mm_mul_pd(_mm_sub_pd(_mm_loadu_pd(p), _mm_loadu_pd(&origin.x)), factor);
    const __m128d z = _mm_mul_sd(_mm_sub_sd(_mm_load_sd(p + 2), _mm_load_sd(&origin.z)), factor);
    return _mm_movelh_ps(_mm_cvtpd_ps(xy), _mm_cvtpd_ps(_mm_move_sd(_mm_setzero_pd(), z)));
  }
  Vec3 to_mesh(const Vec3& p) const { return origin + p / scale; }
};

}  // namespace kerf
