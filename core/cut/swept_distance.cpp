#include "core/cut/swept_distance.h"

#include <algorithm>
#include <limits>

#include "core/base/assert.h"

namespace kerf {

namespace {

constexpr size_t kGroup = 16;

}  // namespace

SweptDistance::SweptDistance(const StrokeRegion& region, std::span<const BeamMove> moves) : region_(region) {
  KERF_ASSERT(region.parts() == moves.size() && !moves.empty());
  for (size_t first = 0; first < moves.size(); first += kGroup) {
    const size_t end = std::min(first + kGroup, moves.size());
    const Pose& middle = moves[first + (end - first) / 2].from;
    Group group{first, end, middle.origin, middle.direction, 0, 0};
    for (const BeamMove& m : moves.subspan(first, end - first)) {
      for (const Pose* pose : {&m.from, &m.to}) {
        group.aside = std::max(group.aside, glm::length(pose->origin - group.origin));
        group.apart = std::max(group.apart, glm::length(pose->direction - group.direction));
      }
    }
    groups_.push_back(group);
  }
}

// A bound of the distances from the parts of a group.
double SweptDistance::at_least(const Group& group, const Vec3& p) const {
  constexpr double kRounding = 1e-9;  // beside which the parts of a beam that tilts err by the angle squared
  const Vec3 from = p - group.origin;
  const double away = glm::length(from);
  const double from_axis = glm::length(from - glm::dot(from, group.direction) * group.direction);
  const double aside = group.aside + group.apart * (1 + group.apart) * (away + group.aside);
  return from_axis - aside - region_.part(group.first).radius() - kRounding * (away + group.aside);
}

double SweptDistance::least_of(const Group& group, const Vec3& p) const {
  double least = std::numeric_limits<double>::infinity();
  for (size_t i = group.first; i < group.end; ++i)
    least = std::min(least, region_.part(i).signed_distance(p));
  return least;
}

double SweptDistance::operator()(const Vec3& p) const {
  const Group* nearest = nullptr;
  double bound = std::numeric_limits<double>::infinity();
  for (const Group& group : groups_) {
    const double at_least_here = at_least(group, p);
    if (at_least_here >= bound && nearest) continue;
    bound = at_least_here;
    nearest = &group;
  }
  double least = least_of(*nearest, p);
  for (const Group& group : groups_) {
    if (&group != nearest && at_least(group, p) < least) least = std::min(least, least_of(group, p));
  }
  return least;
}

}  // namespace kerf
