#include "core/physics/chord_contacts.h"

#include <algorithm>
#include <optional>

namespace kerf {

namespace {

constexpr double kParallel = 0.001;  // squared sine of the angle below which chords count as parallel

struct Segment {
  uint32_t index = 0;
  Vec3 from{0}, to{0};
  Vec3 way{0};  // of its middle within the tick
  Vec3 min{0}, max{0};
};

Segment segment(uint32_t index, const Vec3& from, const Vec3& to, const Vec3& way, double margin) {
  Segment s{index, from, to, way};
  s.min = glm::min(glm::min(from, to), glm::min(from, to) + way) - margin;
  s.max = glm::max(glm::max(from, to), glm::max(from, to) + way) + margin;
  return s;
}

bool overlap(const Vec3& min, const Vec3& max, const Vec3& other_min, const Vec3& other_max) {
  return glm::all(glm::lessThanEqual(min, other_max)) && glm::all(glm::lessThanEqual(other_min, max));
}

// The chords of `first`, in the frame of `second`, that come near its bounds within the tick.
std::vector<Segment> near_chords(const MovingBody& first, const MovingBody& second, double margin) {
  const RigidMap now = into(second.now, first.now), next = into(second.next, first.next);
  std::vector<Segment> near;
  for (uint32_t i = 0; i < first.collider->chords.size(); ++i) {
    const Collider::Chord& c = first.collider->chords[i];
    const Vec3 middle = 0.5 * (c.from + c.to);
    const Segment s = segment(i, now(c.from), now(c.to), next(middle) - now(middle), margin);
    if (overlap(s.min, s.max, second.collider->min, second.collider->max)) near.push_back(s);
  }
  return near;
}

std::vector<Segment> chords_within(const MovingBody& body, const std::vector<Segment>& others) {
  std::vector<Segment> near;
  if (others.empty()) return near;
  Vec3 min = others.front().min, max = others.front().max;
  for (const Segment& s : others) {
    min = glm::min(min, s.min);
    max = glm::max(max, s.max);
  }
  for (uint32_t i = 0; i < body.collider->chords.size(); ++i) {
    const Collider::Chord& c = body.collider->chords[i];
    const Segment s = segment(i, c.from, c.to, Vec3(0), 0);
    if (overlap(s.min, s.max, min, max)) near.push_back(s);
  }
  return near;
}

// Where two lines come nearest.
struct Crossing {
  Vec3 normal{0};       // unit, across both
  double distance = 0;  // along it from the second line to the first
  double s = 0, t = 0;  // along the first and the second chord, from 0 to 1
  bool within() const { return s >= 0 && s <= 1 && t >= 0 && t <= 1; }
};

std::optional<Crossing> crossing(const Segment& a, const Segment& b, double reach) {
  const Vec3 u = a.to - a.from, v = b.to - b.from;
  const Vec3 across = glm::cross(u, v);
  const double uu = glm::dot(u, u), vv = glm::dot(v, v), area2 = glm::dot(across, across);
  if (!(area2 > kParallel * uu * vv)) return std::nullopt;
  Crossing c;
  c.normal = across / glm::length(across);
  Vec3 apart = a.from - b.from;
  c.distance = glm::dot(apart, c.normal);
  const double closing = glm::dot(a.way, c.normal);
  if (std::abs(c.distance) > reach && std::abs(closing) > 0) {
    const double when = -c.distance / closing;
    if (when > 0 && when < 1) apart += when * a.way;  // the chords as they are when their lines meet
  }
  const double uv = glm::dot(u, v), ua = glm::dot(u, apart), va = glm::dot(v, apart);
  c.s = (uv * va - vv * ua) / area2;
  c.t = (uu * va - uv * ua) / area2;
  return c;
}

class Sides {
 public:
  explicit Sides(const std::vector<ChordMemory>& memory) : memory_(memory) {}

  // The normal that is remembered of a pair of chords, or of one of which either chord is a neighbour.
  const Vec3* of(const Collider::Chord& a, uint32_t i, const Collider::Chord& b, uint32_t j) const {
    if (const Vec3* own = find(i, j)) return own;
    for (uint32_t n : a.next) {
      if (const Vec3* side = find(n, j)) return side;
    }
    for (uint32_t n : b.next) {
      if (const Vec3* side = find(i, n)) return side;
    }
    return nullptr;
  }

 private:
  const Vec3* find(uint32_t i, uint32_t j) const {
    const auto before = [](const ChordMemory& m, std::pair<uint32_t, uint32_t> key) {
      return std::pair(m.first, m.second) < key;
    };
    const auto at = std::lower_bound(memory_.begin(), memory_.end(), std::pair(i, j), before);
    return at != memory_.end() && at->first == i && at->second == j ? &at->normal : nullptr;
  }

  const std::vector<ChordMemory>& memory_;
};

}  // namespace

void find_chord_contacts(const MovingBody& first, const MovingBody& second, const ContactLengths& lengths,
                         std::vector<ChordMemory>& memory, std::vector<Contact>& out) {
  const double scale = std::min(first.scale, second.scale);
  const double reach = lengths.reach * scale, skin = lengths.chord_skin * scale;
  const double far = lengths.chord_memory * scale;
  const std::vector<Segment> ours = near_chords(first, second, far);
  const std::vector<Segment> theirs = chords_within(second, ours);
  const Sides sides(memory);
  std::vector<ChordMemory> known;
  for (const Segment& a : ours) {
    for (const Segment& b : theirs) {
      if (!overlap(a.min, a.max, b.min, b.max)) continue;
      std::optional<Crossing> c = crossing(a, b, reach);
      if (!c || !c->within()) continue;
      const Vec3* side =
          sides.of(first.collider->chords[a.index], a.index, second.collider->chords[b.index], b.index);
      const Vec3 in_world = second.now.turn * c->normal;
      const bool turned = side ? glm::dot(in_world, *side) < 0 : c->distance < 0;
      if (turned) {
        c->normal = -c->normal;
        c->distance = -c->distance;
      }
      const double closing = std::max(-glm::dot(a.way, c->normal), 0.0);
      if (c->distance > std::max(far, closing + reach)) continue;
      known.push_back({a.index, b.index, second.now.turn * c->normal});
      if (c->distance > closing + reach) continue;
      Contact& contact = out.emplace_back();
      contact.at = second.now(a.from + c->s * (a.to - a.from));
      contact.normal = known.back().normal;
      contact.distance = c->distance - skin;
      contact.feature = (uint64_t{a.index} + 1) << 32 | b.index;
    }
  }
  memory = std::move(known);
}

}  // namespace kerf
