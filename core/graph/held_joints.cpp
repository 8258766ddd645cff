#include "core/graph/held_joints.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "core/mesh/point_to_triangle.h"

namespace kerf {

namespace {

// What is known of one side of a joint while faces are looked through.
struct SideSoFar {
  std::optional<ConnectedPart> part;
  bool apart = false;
  bool holds() const { return part && !apart; }
};

// Pairs of a loaded face of a body and a side of a joint (its number times two, plus the side).
class Carriers {
 public:
  Carriers(const Joints& joints, BodyId loaded_as) {
    for (uint32_t j = 0; j < joints.all.size(); ++j) {
      if (joints.all[j].body != loaded_as) continue;
      for (uint32_t s = 0; s < 2; ++s) {
        for (const uint32_t f : joints.all[j].sides[s].faces) pairs_.emplace_back(f, 2 * j + s);
      }
    }
    std::sort(pairs_.begin(), pairs_.end());
    for (uint32_t i = 0; i < pairs_.size(); ++i) {
      if (first_.size() <= pairs_[i].first) first_.resize(pairs_[i].first + 1, kNone);
      first_[pairs_[i].first] = std::min(first_[pairs_[i].first], i);
    }
  }

  bool empty() const { return pairs_.empty(); }

  template <typename Visit>
  void for_each_side(FaceId loaded, Visit visit) const {
    if (loaded.index >= first_.size() || first_[loaded.index] == kNone) return;
    for (size_t i = first_[loaded.index]; i < pairs_.size() && pairs_[i].first == loaded.index; ++i)
      visit(pairs_[i].second);
  }

 private:
  static constexpr uint32_t kNone = 0xffffffffu;
  std::vector<std::pair<uint32_t, uint32_t>> pairs_;
  std::vector<uint32_t> first_;  // by loaded face: its first pair
};

bool is_near(const JointSide& side, const Triangle& t) {
  return squared_distance(side.point, t) <= side.radius * side.radius;
}

void look_through(BodyId id, const Body& body, const Joints& joints, const Carriers& carriers,
                  std::vector<SideSoFar>& sides) {
  for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
    if (!body.mesh.is_live(FaceId(f))) continue;
    carriers.for_each_side(body.loaded_face(body.mesh.data(FaceId(f)).base), [&](uint32_t side) {
      if (!is_near(joints.all[side / 2].sides[side % 2], body.mesh.triangle(FaceId(f)))) return;
      const ConnectedPart part = part_of(id, body, FaceId(f));
      if (!sides[side].part) sides[side].part = part;
      if (*sides[side].part != part) sides[side].apart = true;
    });
  }
}

}  // namespace

ConnectedPart part_of(BodyId id, const Body& body, FaceId f) {
  const uint32_t label = body.mesh.data(f).piece;
  return {id, label, body.components.at_home(body.mesh.data(f).base, label)};
}

std::vector<HeldJoint> held_joints(const World& world) {
  const std::vector<Joint>& all = world.joints().all;
  std::vector<HeldJoint> held;
  if (all.empty()) return held;
  std::vector<SideSoFar> sides(2 * all.size());
  std::map<BodyId, Carriers> carriers;  // by the body as which faces were loaded
  for (const BodyId id : world.ids()) {
    const BodyId loaded_as = world.body(id).loaded_as;
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
