#include "core/mesh/openmesh/followed_faces.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <limits>
#include <utility>

#include "core/mesh/point_to_triangle.h"

namespace kerf {

namespace {

using Handle = OpenMeshKernel::FaceHandle;
using Face = FollowedFaces::Around::Face;

// The part of the area of a face that its quarters may leave open though it lies over followed faces alone:
// they stand for areas that reach beyond its edges.
constexpr double kOpenPart = 0.3;

Vec3 middle_of(const Triangle& t) { return (t[0] + t[1] + t[2]) / 3.0; }

std::array<Vec3, 4> middles_of_quarters(const Triangle& t) {
  const Vec3 middle = middle_of(t);
  return {0.5 * (middle + t[0]), 0.5 * (middle + t[1]), 0.5 * (middle + t[2]), middle};
}

// The index of the nearest face.
size_t nearest_to(const Vec3& p, const std::vector<Face>& faces) {
  size_t nearest = 0;
  double least = squared_distance(p, faces[0].corners);
  for (size_t i = 1; i < faces.size() && least > 0; ++i) {
    const double distance2 = squared_distance(p, faces[i].corners);
    if (distance2 >= least) continue;
    least = distance2;
    nearest = i;
  }
  return nearest;
}

size_t handle_of(const Sheets& sheets, FaceId f) {
  const auto at = std::lower_bound(sheets.faces.begin(), sheets.faces.end(), f);
  assert(at != sheets.faces.end() && *at == f);
  return static_cast<size_t>(at - sheets.faces.begin());
}

}  // namespace

FollowedFaces::FollowedFaces(const Mesh& mesh, const Sheets& sheets, const Followed& followed)
    : faces_(followed.faces), elsewhere_(followed.elsewhere), most_mixed_(followed.most_mixed) {
  if (faces_.empty()) return;
  lying_.resize(sheets.faces.size());
  for (uint32_t i = 0; i < faces_.size(); ++i) {
    Lying& own = lying_[handle_of(sheets, faces_[i].face)];
    own.middle = i;
    Triangle corners = mesh.triangle(faces_[i].face);
    for (Vec3& p : corners) p = sheets.frame.scaled(p);
    areas_.push_back(0.25 * triangle_area(corners));
    for (const Vec3& middle : middles_of_quarters(corners)) {
      next_.push_back(std::exchange(own.first, static_cast<uint32_t>(next_.size())));
      middles_.push_back(middle);
    }
  }
}

std::vector<uint32_t> FollowedFaces::quarters_before(const Around& around) const {
  std::vector<uint32_t> quarters;
  for (const Face& f : around.before) {
    for (uint32_t q = on(f.face).first; q != kNone; q = next_[q]) quarters.push_back(q);
  }
  return quarters;
}

// A face on which quarters leave too much open has the value where its middle lies as well and, if not all
// around was followed, that of elsewhere.
bool FollowedFaces::stay_apart(const Around& around) {
  assert(!around.before.empty() && !around.after.empty());
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  std::vector<Mixed> mixed(around.after.size(), {kInfinity, -kInfinity});
  const auto mix = [](Mixed& into, double value) {
    into.least = std::min(into.least, value);
    into.most = std::max(into.most, value);
  };
  for (const uint32_t q : quarters_before(around)) {
    Mixed& into = mixed[nearest_to(middles_[q], around.after)];
    mix(into, value_of(q / 4));
    into.area += areas_[q / 4];
  }
  const bool all_followed =
      std::all_of(around.before.begin(), around.before.end(), [&](const Face& f) { return lie_on(f.face); });
  for (size_t i = 0; i < mixed.size(); ++i) {
    const Triangle& corners = around.after[i].corners;
    if (mixed[i].area < (1 - kOpenPart) * triangle_area(corners)) {
      const Face& below = around.before[nearest_to(middle_of(corners), around.before)];
      mix(mixed[i], value_of(on(below.face).middle));
      if (!all_followed) mix(mixed[i], elsewhere_);
    }
    if (mixed[i].most - mixed[i].least > most_mixed_) return false;
  }
  return true;
}

void FollowedFaces::hand_on(const Around& around) {
  assert(!around.before.empty() && !around.after.empty());
  const std::vector<uint32_t> quarters = quarters_before(around);
  std::vector<uint32_t> below;  // by face after: the followed face where its middle lies
  for (const Face& f : around.after)
    below.push_back(on(around.before[nearest_to(middle_of(f.corners), around.before)].face).middle);
  for (const Face& f : around.before) on(f.face) = {};
  for (size_t i = 0; i < below.size(); ++i) on(around.after[i].face).middle = below[i];
  for (const uint32_t q : quarters) {
    Lying& lying = on(around.after[nearest_to(middles_[q], around.after)].face);
    next_[q] = std::exchange(lying.first, q);
  }
}

std::vector<FaceId> FollowedFaces::middles(const Sheets& sheets, std::span<const FaceId> origins) const {
  std::vector<FaceId> middles;
  if (faces_.empty()) return middles;
  for (const FaceId origin : origins) {
    const uint32_t face = lying_[handle_of(sheets, origin)].middle;
    middles.push_back(face == kNone ? FaceId() : faces_[face].face);
  }
  return middles;
}

}  // namespace kerf
