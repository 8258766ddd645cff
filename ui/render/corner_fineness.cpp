#include "ui/render/corner_fineness.h"

#include <algorithm>

#include "ui/render/face_slots.h"

namespace kerf {

namespace {
constexpr size_t kLargestFan = 24;                   // no more faces are looked at around a corner
constexpr float kOnRim = 1.10f, kBesideRim = 0.89f;  // times the halvings of small faces
}  // namespace

void CornerFineness::find_fan(const Mesh& mesh, FaceId f, const Vec3& corner) {
  fan_.assign(1, f);
  for (size_t i = 0; i < fan_.size() && fan_.size() < kLargestFan; ++i) {
    neighbours_.clear();
    mesh.append_nearest_neighbours(fan_[i], neighbours_);
    for (const FaceId n : neighbours_) {
      const Triangle t = mesh.triangle(n);
      const bool shares = t[0] == corner || t[1] == corner || t[2] == corner;
      if (shares && std::find(fan_.begin(), fan_.end(), n) == fan_.end()) fan_.push_back(n);
    }
  }
}

// Whether the surface ends at the corner: one of the edges that run to it from the faces of the fan has a
// face on one side only.
bool CornerFineness::fan_ends(const Mesh& mesh, const Vec3& corner) {
  if (fan_.size() >= kLargestFan) return false;
  spokes_.clear();
  for (const FaceId f : fan_) {
    for (const Vec3& p : mesh.triangle(f)) {
      if (p != corner) spokes_.push_back(p);
    }
  }
  return std::any_of(spokes_.begin(), spokes_.end(),
                     [&](const Vec3& p) { return std::count(spokes_.begin(), spokes_.end(), p) == 1; });
}

std::array<float, 3> CornerFineness::of(const Mesh& mesh, FaceId f) {
  if (!mesh.is_live(f)) return {};
  const uint32_t own = mesh.data(f).halvings;
  std::array<float, 3> fineness;
  fineness.fill(static_cast<float>(own));
  if (own < kLeastSmall) return fineness;
  const Triangle t = mesh.triangle(f);
  for (size_t i = 0; i < 3; ++i) {
    find_fan(mesh, f, t[i]);
    uint32_t least = own, most = own;
    float sum = 0;
    for (const FaceId g : fan_) {
      const uint32_t h = mesh.data(g).halvings;
      least = std::min(least, h);
      most = std::max(most, h);
      sum += static_cast<float>(h);
    }
    const float mean = sum / static_cast<float>(fan_.size());
    fineness[i] = fan_ends(mesh, t[i]) ? kOnRim * static_cast<float>(most)
                                       : kBesideRim * 0.5f * (static_cast<float>(least) + mean);
  }
  return fineness;
}

const std::vector<FaceId>& CornerFineness::faces_around(const Mesh& mesh, FaceId f) {
  around_.clear();
  if (mesh.data(f).halvings < kLeastSmall) return around_;
  for (const Vec3& corner : mesh.triangle(f)) {
    find_fan(mesh, f, corner);
    around_.insert(around_.end(), fan_.begin(), fan_.end());
  }
  return around_;
}

}  // namespace kerf
