#include "core/cut/chord_test.h"

#include <cmath>

namespace kerf {

namespace {

class ChordTest {
 public:
  ChordTest(const StrokeRegion& region, FaceId face, const Triangle& at, const std::array<double, 3>& d,
            double chord, double graze)
      : region_(region), face_(face), at_(at), d_(d), chord_(chord), graze_(graze) {}

  bool fails() {
    const bool any_inside = d_[0] < 0 || d_[1] < 0 || d_[2] < 0;
    const bool any_outside = d_[0] > 0 || d_[1] > 0 || d_[2] > 0;
    if (!any_inside && any_outside && region_.reaches_into(face_, at_, graze_)) return true;
    for (int i = 0; i < 3; ++i) {
      if (edge_fails(i, (i + 1) % 3)) return true;
    }
    if (!any_outside) return region_.signed_distance(face_, (at_[0] + at_[1] + at_[2]) / 3.0) > graze_;
    return any_inside && cut_fails();
  }

 private:
  bool edge_fails(int i, int k) {
    if (d_[i] > 0 && d_[k] > 0) return passes_through(at_[i], at_[k]);
    if (d_[i] == 0 && d_[k] == 0) return leaves_boundary(at_[i], at_[k]);
    if (d_[i] <= 0 && d_[k] <= 0) return leaves_region(at_[i], at_[k]);
    const int in = d_[i] < d_[k] ? i : k, out = in == i ? k : i;
    if (d_[in] == 0) return passes_through(at_[in], at_[out]);
    const Vec3 crossing = region_.crossing(face_, at_[in], at_[out]);
    if (leaves_region(at_[in], crossing) || passes_through(crossing, at_[out])) return true;
    ends_[ends_count_++] = crossing;
    return false;
  }

  bool passes_through(const Vec3& a, const Vec3& b) const {
    return region_.reaches_into(face_, {a, b, b}, graze_);
  }

  bool leaves_region(const Vec3& a, const Vec3& b) const {
    return any_between(a, b, [&](double distance) { return distance > graze_; });
  }

  bool leaves_boundary(const Vec3& a, const Vec3& b) const {
    return any_between(a, b, [&](double distance) { return std::abs(distance) > chord_; });
  }

  template <typename Wrong>
  bool any_between(const Vec3& a, const Vec3& b, Wrong wrong) const {
    for (int eighth = 1; eighth < 8; ++eighth) {
      if (wrong(region_.signed_distance(face_, a + 0.125 * eighth * (b - a)))) return true;
    }
    return false;
  }

  // The chord runs between two crossings, or from one to a corner on the boundary.
  bool cut_fails() {
    for (int i = 0; i < 3; ++i) {
      if (d_[i] == 0 && ends_count_ < 2) ends_[ends_count_++] = at_[i];
    }
    return ends_count_ == 2 && leaves_boundary(ends_[0], ends_[1]);
  }

  const StrokeRegion& region_;
  FaceId face_;
  const Triangle& at_;
  const std::array<double, 3>& d_;
  double chord_, graze_;
  std::array<Vec3, 3> ends_{};
  int ends_count_ = 0;
};

}  // namespace

bool chord_fails(const StrokeRegion& region, FaceId face, const Triangle& at,
                 const std::array<double, 3>& distances, double chord, double graze) {
  return ChordTest(region, face, at, distances, chord, graze).fails();
}

}  // namespace kerf
