#include "core/joints/held_joints.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <span>

#include "core/base/assert.h"
#include "core/mesh/point_to_triangle.h"

namespace kerf {

namespace {

// The knowledge about one side of a joint while faces are looked through.
struct SideSoFar {
  std::optional<ConnectedPart> part;
  bool apart = false;
  bool reaches_pin = false;
  bool holds() const { return part && !apart && reaches_pin; }
  // Whether a face of this part may change what is known.
  bool is_open(const ConnectedPart& other) const {
    return !part || (!apart && (*part != other || !reaches_pin));
  }
  void add(const ConnectedPart& other) {
    apart = part && *part != other;
    if (!part) part = other;
  }
};

// By loaded face of a body, the sides of joints that it carries (the number of a joint times two, plus the
// side).
class Carriers {
 public:
  Carriers(const Joints& joints, BodyId loaded_as) {
    for_each_pair(joints, loaded_as, [&](uint32_t face, uint32_t) {
      if (first_.size() <= face + 1) first_.resize(size_t{face} + 2, 0);
      ++first_[face];
    });
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    if (!first_.empty()) sides_.resize(first_.back());
    for_each_pair(joints, loaded_as, [&](uint32_t face, uint32_t side) { sides_[--first_[face]] = side; });
  }

  bool empty() const { return sides_.empty(); }

  std::span<const uint32_t> sides_of(FaceId loaded) const {
    if (loaded.index + 1 >= first_.size()) return {};
    const uint32_t first = first_[loaded.index];
    return std::span(sides_).subspan(first, first_[loaded.index + 1] - first);
  }

 private:
  template <typename Visit>
  static void for_each_pair(const Joints& joints, BodyId loaded_as, Visit visit) {
    for (uint32_t j = 0; j < joints.all.size(); ++j) {
      if (joints.all[j].body != loaded_as) continue;
      for (uint32_t s = 0; s < 2; ++s) {
        for (const uint32_t f : joints.all[j].sides[s].faces) visit(f, 2 * j + s);
      }
    }
  }

  std::vector<uint32_t> sides_;
  std::vector<uint32_t> first_;  // by loaded face, of sides_
};

bool is_near(const Vec3& point, double radius, const Triangle& t) {
  const Vec3 low = glm::min(glm::min(t[0], t[1]), t[2]), high = glm::max(glm::max(t[0], t[1]), t[2]);
  for (int k = 0; k < 3; ++k) {
    if (low[k] - point[k] > radius || point[k] - high[k] > radius) return false;
  }
  return squared_distance(point, t) <= radius * radius;
}

void look_through(BodyId id, const Body& body, const Joints& joints, const Carriers& carriers,
                  std::vector<SideSoFar>& sides) {
  for (uint32_t slot = 0; slot < body.mesh.face_slots(); ++slot) {
    const FaceId f(slot);
    if (!body.mesh.is_live(f)) continue;
    const std::span<const uint32_t> carried = carriers.sides_of(body.loaded_face(body.loaded_base(f)));
    if (carried.empty()) continue;
    const ConnectedPart part = part_of(id, body, f);
    for (const uint32_t side : carried) {
      SideSoFar& known = sides[side];
      if (!known.is_open(part)) continue;
      const Joint& joint = joints.all[side / 2];
      const JointSide& own = joint.sides[side % 2];
      const Triangle t = body.mesh.triangle(f);
      if (!is_near(own.point, own.radius, t)) continue;
      known.add(part);
      known.reaches_pin = known.reaches_pin || is_near(joint.anchor, own.reaches_pin, t);
    }
  }
}

}  // namespace

ConnectedPart part_of(BodyId id, const Body& body, FaceId f) {
  const uint32_t label = body.mesh.data(f).piece;
  return {id, label, body.components.at_home(body.loaded_base(f), label)};
}

LoadedBodies bodies_with_joints(const Joints& joints) {
  LoadedBodies bodies;
  for (const Joint& joint : joints.all) bodies.push_back(joint.body);
  std::ranges::sort(bodies);
  bodies.erase(std::unique(bodies.begin(), bodies.end()), bodies.end());
  return bodies;
}

std::vector<HeldJoint> held_joints(const World& world) {
  return held_joints(world, bodies_with_joints(world.joints()));
}

std::vector<HeldJoint> held_joints(const World& world, const LoadedBodies& of) {
  KERF_ASSERT(std::ranges::is_sorted(of));
  const std::vector<Joint>& all = world.joints().all;
  std::vector<HeldJoint> held;
  if (all.empty() || of.empty()) return held;
  std::vector<SideSoFar> sides(2 * all.size());
  std::map<BodyId, Carriers> carriers;  // by the body as which faces were loaded
  for (const BodyId id : world.ids()) {
    const BodyId loaded_as = world.body(id).loaded_as;
    if (!std::ranges::binary_search(of, loaded_as)) continue;
    auto at = carriers.find(loaded_as);
    if (at == carriers.end()) at = carriers.emplace(loaded_as, Carriers(world.joints(), loaded_as)).first;
    if (!at->second.empty()) look_through(id, world.body(id), world.joints(), at->second, sides);
  }
  for (uint32_t j = 0; j < all.size(); ++j) {
    const SideSoFar &a = sides[2 * j], &b = sides[2 * j + 1];
    if (a.holds() && b.holds()) held.push_back({j, {*a.part, *b.part}});
  }
  return held;
}

}  // namespace kerf
