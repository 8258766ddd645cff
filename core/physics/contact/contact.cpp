#include "core/physics/contact/contact.h"

#include <algorithm>
#include <optional>
#include <span>

#include "core/base/assert.h"
#include "core/physics/contact/collider.h"
#include "core/physics/contact/penetration.h"

namespace kerf {

void take_impulses(const PairMemory& memory, std::vector<Contact>& contacts) {
  for (Contact& c : contacts) {
    const auto at = std::ranges::lower_bound(memory.impulses, c.feature, {}, &ImpulseMemory::feature);
    if (at != memory.impulses.end() && at->feature == c.feature) c.impulse = at->impulse;
  }
}

namespace {

// Removes the point at a rim that made a contact, if any.
void forget_at_rim(uint64_t feature, PairMemory& memory) {
  if (feature >> 32 != 0) return;
  const bool of_second = (feature & kOnSecond) != 0;
  const auto point = static_cast<uint32_t>(of_second ? feature - kOnSecond : feature);
  if (!is_at_rim(point)) return;
  std::erase_if(of_second ? memory.points_of_second : memory.points_of_first,
                [&](const PointMemory& m) { return m.point == point; });
}

// Height at which a contact is ranked.
struct Rank {
  double bonus = 0;
  double operator()(const Contact& c) const { return c.distance - (c.impulse[0] > 0 ? bonus : 0); }
};

uint32_t deepest_of(const std::vector<Contact>& contacts, const Rank& rank = {}) {
  KERF_ASSERT(!contacts.empty());
  const auto deepest = std::ranges::min_element(contacts, {}, rank);
  return static_cast<uint32_t>(deepest - contacts.begin());
}

// Keeps the selected contacts, in the order in which they were found.
void keep(std::vector<Contact>& contacts, std::vector<uint32_t> selected) {
  KERF_ASSERT(selected.size() <= kMaxContacts && selected.size() <= contacts.size());
  std::ranges::sort(selected);
  std::vector<Contact> kept;
  for (const uint32_t c : selected) kept.push_back(contacts[c]);
  contacts = std::move(kept);
}

// Returns positions of contacts on a plane, along the longest distance and across it, relative to extents.
std::vector<Vec3> places_on_plane(const std::vector<Contact>& contacts, uint32_t from, const Vec3& up) {
  KERF_ASSERT(from < contacts.size());
  std::vector<Vec3> places;
  for (const Contact& c : contacts) {
    const Vec3 way = c.at - contacts[from].at;
    places.push_back(way - glm::dot(way, up) * up);
  }
  const Vec3& longest = *std::ranges::max_element(places, {}, [](const Vec3& p) { return glm::dot(p, p); });
  const double length = glm::length(longest);
  if (!(length > 0)) return places;
  const Vec3 along = longest / length, across = glm::cross(up, along);
  double width = 0;
  for (const Vec3& p : places) width = std::max(width, std::abs(glm::dot(p, across)));
  for (Vec3& p : places) p = {glm::dot(p, along) / length, width > 0 ? glm::dot(p, across) / width : 0, 0};
  return places;
}

// Replaces each selected contact by the deepest of those nearer to it than to the other selected ones.
void take_deepest_near(const std::vector<Contact>& contacts, const std::vector<Vec3>& places,
                       const Rank& rank, std::vector<uint32_t>& selected) {
  std::vector<uint32_t> deepest = selected;
  for (uint32_t i = 0; i < contacts.size(); ++i) {
    const auto apart = [&](uint32_t c) { return glm::dot(places[i] - places[c], places[i] - places[c]); };
    const auto nearest =
        static_cast<size_t>(std::ranges::min_element(selected, {}, apart) - selected.begin());
    if (rank(contacts[i]) < rank(contacts[deepest[nearest]])) deepest[nearest] = i;
  }
  selected = std::move(deepest);
}

constexpr double kParallel = 0.001;  // squared sine of the angle below which chords count as parallel

struct Segment {
  uint32_t index = 0;
  Vec3 from{0}, to{0};
  Vec3 way{0};  // of its midpoint within the tick
  Box bounds;   // of its way
};

Segment segment(uint32_t index, const Vec3& from, const Vec3& to, const Vec3& way, double margin) {
  const Vec3 min = glm::min(from, to), max = glm::max(from, to);
  return {index, from, to, way, Box{glm::min(min, min + way), glm::max(max, max + way)}.wider(margin)};
}

// Returns the chords of `first`, in the frame of `second`, that come near its bounds within the tick.
std::vector<Segment> near_chords(const MovingBody& first, const MovingBody& second, double margin) {
  const RigidMap now = into(second.now, first.now), next = into(second.next, first.next);
  std::vector<Segment> near;
  const auto passes_near = [&](const Cluster& cluster) {
    return second.collider->space.meets(way_of(cluster, now, next).wider(margin));
  };
  first.collider->chord_clusters.for_each(passes_near, [&](uint32_t i) {
    const Collider::Chord& c = first.collider->chords[i];
    const Vec3 middle = 0.5 * (c.from + c.to);
    const Segment s = segment(i, now(c.from), now(c.to), next(middle) - now(middle), margin);
    if (second.collider->space.meets(s.bounds)) near.push_back(s);
  });
  return near;
}

std::vector<Segment> chords_within(const MovingBody& body, const std::vector<Segment>& others) {
  std::vector<Segment> near;
  if (others.empty()) return near;
  Box around;
  for (const Segment& s : others) around.add(s.bounds);
  const auto is_around = [&](const Cluster& cluster) {
    return Box{cluster.centre, cluster.centre}.wider(cluster.radius).overlaps(around);
  };
  body.collider->chord_clusters.for_each(is_around, [&](uint32_t i) {
    const Collider::Chord& c = body.collider->chords[i];
    const Segment s = segment(i, c.from, c.to, Vec3(0), 0);
    if (s.bounds.overlaps(around)) near.push_back(s);
  });
  return near;
}

// Chords adjacent in a list, and near each other because their clusters are.
struct Run {
  std::span<const Segment> segments;
  Box bounds;
};

std::vector<Run> runs_of(std::span<const Segment> segments) {
  constexpr size_t kMost = 8;
  std::vector<Run> runs;
  for (; !segments.empty(); segments = segments.subspan(runs.back().segments.size())) {
    Run& run = runs.emplace_back();
    run.segments = segments.first(std::min(kMost, segments.size()));
    for (const Segment& s : run.segments) run.bounds.add(s.bounds);
  }
  return runs;
}

// The closest points of two lines.
struct Crossing {
  Vec3 normal{0};       // unit, across both
  double distance = 0;  // from the second line to the first along the normal
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
    if (when > 0 && when < 1) apart += when * a.way;  // the chords at the time when their lines meet
  }
  const double uv = glm::dot(u, v), ua = glm::dot(u, apart), va = glm::dot(v, apart);
  c.s = (uv * va - vv * ua) / area2;
  c.t = (uu * va - uv * ua) / area2;
  return c;
}

void find_points_of_second(const MovingBody& first, const MovingBody& second, const ContactLengths& lengths,
                           PairMemory& memory, std::vector<Contact>& out) {
  const size_t before = out.size();
  find_point_contacts(second, first, lengths, memory.points_of_second, out);
  for (size_t i = before; i < out.size(); ++i) {
    Contact& c = out[i];
    c.at -= c.distance * c.normal;  // onto the first body
    c.normal = -c.normal;
    c.feature += kOnSecond;
  }
}

constexpr double kStays = 0.1;  // share of the skin: see reduce_on_plane
constexpr double kNearLowest =
    0.3;  // share of the reach, above the lowest point, within which the ground is tested

// Height of points of a body above a plane [m].
class Height {
 public:
  Height(const RigidMap& map, const Vec3& up, double level)
      : up_(glm::transpose(map.turn) * up), offset_(glm::dot(map.shift, up) - level) {}

  double operator()(const Vec3& p) const { return glm::dot(up_, p) + offset_; }
  // Returns the height of the lowest corner of a box.
  double least(const Box& box) const {
    return (*this)(0.5 * (box.min + box.max)) - glm::dot(glm::abs(up_), 0.5 * (box.max - box.min));
  }

 private:
  Vec3 up_;  // in the frame of the body
  double offset_;
};

}  // namespace

void remember_impulses(const std::vector<Contact>& contacts, PairMemory& memory) {
  memory.impulses.clear();
  memory.touching = false;
  for (const Contact& c : contacts) {
    if (c.impulse[0] == 0) {
      forget_at_rim(c.feature, memory);
      continue;
    }
    memory.impulses.push_back({c.feature, c.impulse});
    memory.touching = true;
  }
  std::ranges::sort(memory.impulses, {}, &ImpulseMemory::feature);
}

void reduce_contacts(std::vector<Contact>& contacts) {
  if (contacts.size() <= kMaxContacts) return;
  std::vector<Vec3> places;
  for (const Contact& c : contacts) places.push_back(c.at);
  std::vector<uint32_t> selected{deepest_of(contacts)};
  select_spread_points(places, kMaxContacts, selected);
  keep(contacts, std::move(selected));
}

void reduce_on_plane(std::vector<Contact>& contacts, const Vec3& up, double bonus) {
  KERF_ASSERT(std::abs(glm::dot(up, up) - 1) < 1e-9);
  if (contacts.size() <= kMaxContacts) return;
  const Rank rank{bonus};
  std::vector<uint32_t> selected{deepest_of(contacts, rank)};
  const std::vector<Vec3> places = places_on_plane(contacts, selected[0], up);
  select_spread_points(places, kMaxContacts, selected);
  take_deepest_near(contacts, places, rank, selected);
  keep(contacts, std::move(selected));
}

void find_chord_contacts(const MovingBody& first, const MovingBody& second, const ContactLengths& lengths,
                         std::vector<Contact>& out) {
  KERF_ASSERT(first.scale > 0 && second.scale > 0);
  const double scale = std::min(first.scale, second.scale);
  const double reach = lengths.reach * scale, skin = lengths.chord_skin * scale;
  const std::vector<Segment> ours = near_chords(first, second, reach);
  const std::vector<Segment> theirs = chords_within(second, ours);
  const auto meet = [&](const Segment& a, const Segment& b) {
    if (!a.bounds.overlaps(b.bounds)) return;
    std::optional<Crossing> c = crossing(a, b, reach);
    if (!c || !c->within()) return;
    if (c->distance < 0) {
      c->normal = -c->normal;
      c->distance = -c->distance;
    }
    const double closing = std::max(-glm::dot(a.way, c->normal), 0.0);
    if (c->distance > closing + reach) return;
    Contact& contact = out.emplace_back();
    contact.at = second.now(a.from + c->s * (a.to - a.from));
    contact.normal = second.now.turn * c->normal;
    contact.distance = c->distance - skin;
    contact.feature = (uint64_t{a.index} + 1) << 32 | b.index;
  };
  const std::vector<Run> runs = runs_of(theirs);
  for (const Segment& a : ours) {
    for (const Run& run : runs) {
      if (!a.bounds.overlaps(run.bounds)) continue;
      for (const Segment& b : run.segments) meet(a, b);
    }
  }
}

std::vector<Contact> find_contacts(const MovingBody& first, const MovingBody& second,
                                   const ContactLengths& lengths, PairMemory& memory) {
  KERF_ASSERT(first.id < second.id);
  if (memory.crossed > 0) {
    memory.points_of_first.clear();
    memory.points_of_second.clear();
    const std::optional<Contact> push = push_out(first, second, memory);
    return push ? std::vector{*push} : std::vector<Contact>{};
  }
  std::vector<Contact> contacts;
  find_point_contacts(first, second, lengths, memory.points_of_first, contacts);
  find_points_of_second(first, second, lengths, memory, contacts);
  find_chord_contacts(first, second, lengths, contacts);
  reduce_contacts(contacts);
  take_impulses(memory, contacts);
  return contacts;
}

std::vector<Contact> find_ground_contacts(const MovingBody& body, const Environment& around,
                                          const ContactLengths& lengths, const PairMemory& memory) {
  std::vector<Contact> contacts;
  if (!around.ground) return contacts;
  KERF_ASSERT(body.moves() && body.scale > 0);
  const Vec3 up = around.up();
  const double reach = lengths.reach * body.scale;
  const double level = *around.ground + lengths.ground_skin * body.scale;
  const Height now(body.now, up, level), next(body.next, up, level);
  if (std::min(now.least(body.collider->bounds), next.least(body.collider->bounds)) > reach) return contacts;
  double lowest = reach;
  for (const Vec3& p : body.collider->corners) lowest = std::min({lowest, now(p), next(p)});
  const double near = std::min(reach, std::max(lowest, 0.0) + kNearLowest * reach);
  for (uint32_t i = 0; i < body.collider->corners.size(); ++i) {
    const Vec3& p = body.collider->corners[i];
    const double distance = now(p);
    if (std::min(distance, next(p)) <= near) contacts.push_back({body.now(p), up, distance, i, {}});
  }
  take_impulses(memory, contacts);
  reduce_on_plane(contacts, up, kStays * lengths.ground_skin * body.scale);
  return contacts;
}

double depth_below_ground(const MovingBody& body, const RigidMap& map, const Environment& around) {
  if (!around.ground) return 0;
  const Height height(map, around.up(), *around.ground);
  if (height.least(body.collider->bounds) >= 0) return 0;
  double lowest = 0;
  for (const Vec3& p : body.collider->corners) lowest = std::min(lowest, height(p));
  return -lowest;
}

}  // namespace kerf
