#include "core/joints/joint_description.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <iterator>
#include <limits>
#include <vector>

#include "core/base/assert.h"
#include "core/base/deterministic_math.h"
#include "core/mesh/measures.h"

namespace kerf {

namespace {

// The faces of a side of a hinge may extend farther from its pin than as loaded, by this fraction of its
// radius.
constexpr double kPinPlay = 0.1;

class CarrierSearch {
 public:
  CarrierSearch(const JointDescription& joint, const Body& body) : joint_(joint), body_(body) {}

  Result<JointSide> side(size_t i) const {
    const Vec3 point = joint_.near ? (*joint_.near)[i] : joint_.anchor;
    std::vector<Near> near;
    const auto add = [&](uint32_t first, uint32_t last) {
      for (uint32_t f = first; f < last; ++f)
        near.push_back({squared_distance(point, body_.mesh.triangle(FaceId(f))), f});
    };
    if (joint_.parts[i].empty()) add(0, static_cast<uint32_t>(body_.loaded.faces));
    for (const MeshPart& part : body_.named_parts) {
      if (part.name == joint_.parts[i] && !part.name.empty()) add(part.first, part.last);
    }
    if (near.empty()) return wrong("the mesh has no part named \"" + joint_.parts[i] + "\"");
    const Near& nearest = *std::min_element(near.begin(), near.end());
    if (joint_.radius && nearest.distance2 > *joint_.radius * *joint_.radius)
      return wrong("no face of " + name(i) + " is within its radius");
    JointSide side;
    side.component = component(nearest.face);
    side.point = point;
    if (joint_.radius) side.radius = *joint_.radius;
    for (const Near& n : near) {
      if (joint_.radius && n.distance2 > *joint_.radius * *joint_.radius) continue;
      if (component(n.face) == side.component) side.faces.push_back(n.face);
    }
    std::sort(side.faces.begin(), side.faces.end());
    side.faces.erase(std::unique(side.faces.begin(), side.faces.end()), side.faces.end());
    KERF_ASSERT(!side.faces.empty());
    return side;
  }

  double distance_to(const JointSide& side, const Vec3& point) const {
    double least2 = std::numeric_limits<double>::infinity();
    for (const uint32_t f : side.faces)
      least2 = std::min(least2, squared_distance(point, body_.mesh.triangle(FaceId(f))));
    return std::sqrt(least2);
  }

  bool is_near_mesh(const Vec3& p) const {
    const MeshReport& loaded = body_.loaded;
    return glm::length(p - body_.middle()) <= 100 * glm::length(loaded.max - loaded.min);
  }

  Error wrong(const std::string& what) const {
    return bad_input("the joint of " + name(0) + " and " + name(1) + " in " + body_.name + ": " + what);
  }

 private:
  std::string name(size_t i) const {
    if (!joint_.parts[i].empty()) return '"' + joint_.parts[i] + '"';
    return i == 0 ? "the first part" : "the second part";
  }

  struct Near {
    double distance2;
    uint32_t face;
    auto operator<=>(const Near&) const = default;
  };

  uint32_t component(uint32_t face) const {
    const std::vector<uint32_t>& of_base = body_.components.of_base;
    return of_base.empty() ? 0 : of_base[face];
  }

  const JointDescription& joint_;
  const Body& body_;
};

}  // namespace

Result<Joint> make_joint(const JointDescription& joint, BodyId id, const Body& body) {
  const CarrierSearch search(joint, body);
  Joint made;
  made.kind = joint.kind;
  made.body = id;
  made.anchor = joint.anchor;
  const Vec3 size = glm::abs(joint.axis);
  made.axis = glm::normalize(joint.axis / std::max({size.x, size.y, size.z}));
  if (!search.is_near_mesh(joint.anchor)) return search.wrong("its anchor is too far from the mesh");
  if (joint.limits) made.limits = Interval{radians_of(joint.limits->low), radians_of(joint.limits->high)};
  for (size_t i = 0; i < 2; ++i) {
    auto side = search.side(i);
    if (!side) return side.error();
    made.sides[i] = std::move(*side);
    if (made.kind == Joint::Kind::kHinge && joint.radius)
      made.sides[i].reaches_pin = search.distance_to(made.sides[i], made.anchor) + kPinPlay * *joint.radius;
  }
  std::vector<uint32_t> both;
  std::set_intersection(made.sides[0].faces.begin(), made.sides[0].faces.end(), made.sides[1].faces.begin(),
                        made.sides[1].faces.end(), std::back_inserter(both));
  if (!both.empty())
    return search.wrong("a face carries both sides: move \"near\" apart or reduce \"radius\"");
  return made;
}

}  // namespace kerf
