#include "tests/support/free_parts.h"

#include <algorithm>
#include <map>
#include <set>

#include "core/base/containers.h"
#include "core/edit/separation.h"
#include "core/mesh/measures.h"

namespace kerf::test {

namespace {

// The connected parts of one body, numbered from `first`.
struct Parts {
  BodyId id;
  const Body* body = nullptr;
  uint32_t first = 0;
  std::vector<uint32_t> of_face;    // by face slot, less `first`
  std::vector<double> area;         // by part
  std::vector<uint32_t> loaded_in;  // by part: the component as loaded

  uint32_t count() const { return static_cast<uint32_t>(area.size()); }
  uint32_t largest() const {
    return static_cast<uint32_t>(std::max_element(area.begin(), area.end()) - area.begin());
  }
};

Parts parts_of(BodyId id, const Body& body, uint32_t first) {
  Parts parts{id, &body, first, {}, {}, {}};
  const uint32_t count = label_components(body.mesh, parts.of_face);
  parts.area.resize(count, 0);
  parts.loaded_in.resize(count, 0);
  for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
    if (!body.mesh.is_live(FaceId(f))) continue;
    parts.area[parts.of_face[f]] += triangle_area(body.mesh.triangle(FaceId(f)));
    if (!body.components.of_base.empty())
      parts.loaded_in[parts.of_face[f]] = body.components.of_base[body.mesh.data(FaceId(f)).base.index];
  }
  return parts;
}

// The parts of all bodies that carry a side of a joint, by body and part.
using Carriers = std::set<std::pair<size_t, uint32_t>>;

// By side: the number of a joint times two, plus the side.
std::vector<Carriers> carriers_of_sides(const std::vector<Parts>& bodies, const std::vector<Joint>& joints) {
  const auto side_of = [&](size_t side) -> const JointSide& { return joints[side / 2].sides[side % 2]; };
  std::map<uint32_t, std::vector<size_t>> sides_on;  // by loaded face
  for (size_t side = 0; side < 2 * joints.size(); ++side) {
    for (const uint32_t f : side_of(side).faces) sides_on[f].push_back(side);
  }
  std::vector<Carriers> found(2 * joints.size());
  for (size_t b = 0; b < bodies.size(); ++b) {
    const Body& body = *bodies[b].body;
    for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
      if (!body.mesh.is_live(FaceId(f))) continue;
      const auto on = sides_on.find(body.loaded_face(body.mesh.data(FaceId(f)).base).index);
      if (on == sides_on.end()) continue;
      for (const size_t side : on->second) {
        const JointSide& s = side_of(side);
        if (squared_distance(s.point, body.mesh.triangle(FaceId(f))) <= s.radius * s.radius)
          found[side].emplace(b, bodies[b].of_face[f]);
      }
    }
  }
  return found;
}

// What joints hold together: unites welded parts, and parts of one body that turn on each other.
void unite_held(const std::vector<Parts>& bodies, const std::vector<Joint>& joints, UnionFind& held) {
  const std::vector<Carriers> carriers = carriers_of_sides(bodies, joints);
  for (size_t j = 0; j < joints.size(); ++j) {
    const Carriers &first = carriers[2 * j], &second = carriers[2 * j + 1];
    if (first.size() != 1 || second.size() != 1) continue;
    const auto& [body, part] = *first.begin();
    const auto& [other_body, other_part] = *second.begin();
    if (body == other_body || joints[j].kind == Joint::Kind::kWeld)
      held.unite(bodies[body].first + part, bodies[other_body].first + other_part);
  }
}

bool has_free_part(const Parts& parts, UnionFind& held) {
  std::set<uint32_t> loaded_in;
  for (uint32_t p = 0; p < parts.count(); ++p) {
    if (!loaded_in.insert(parts.loaded_in[p]).second) return true;
    if (held.find(parts.first + p) != held.find(parts.first)) return true;
  }
  return false;
}

}  // namespace

std::vector<BodyId> bodies_with_free_parts(const World& world, BodyId loaded_as) {
  std::vector<Parts> bodies;
  uint32_t count = 0;
  for (const BodyId id : world.ids()) {
    if (world.body(id).loaded_as != loaded_as) continue;
    bodies.push_back(parts_of(id, world.body(id), count));
    count += bodies.back().count();
  }
  std::vector<Joint> joints;
  std::set<uint32_t> named;
  for (const Joint& joint : world.joints().all) {
    if (joint.body != loaded_as) continue;
    joints.push_back(joint);
    named.insert({joint.sides[0].component, joint.sides[1].component});
  }
  UnionFind held(count);
  unite_held(bodies, joints, held);
  for (const Parts& parts : bodies) {
    for (uint32_t p = 0; p < parts.count(); ++p) {
      if (!named.contains(parts.loaded_in[p])) held.unite(parts.first + p, parts.first + parts.largest());
    }
  }
  std::vector<BodyId> found;
  for (const Parts& parts : bodies) {
    if (has_free_part(parts, held)) found.push_back(parts.id);
  }
  return found;
}

}  // namespace kerf::test
