#include "core/physics/contact/pair_contacts.h"

#include <algorithm>
#include <optional>

#include "core/base/assert.h"
#include "core/physics/collider/spread_points.h"
#include "core/physics/contact/chord_contacts.h"
#include "core/physics/contact/chord_points.h"
#include "core/physics/contact/point_contacts.h"
#include "core/physics/contact/push_out.h"

namespace kerf {

namespace {

constexpr size_t kMostContacts = 8;
constexpr double kNearLowest = 0.3;  // of the reach, above the lowest point: where the ground is looked at
constexpr uint64_t kPointsOfSecond = uint64_t{1} << 31;  // added to the features of contacts found by them

// Keeps the deepest contact and those that lie farthest apart, in the order in which they were found.
void reduce(std::vector<Contact>& contacts) {
  if (contacts.size() <= kMostContacts) return;
  std::vector<Vec3> places;
  uint32_t deepest = 0;
  for (uint32_t i = 0; i < contacts.size(); ++i) {
    places.push_back(contacts[i].at);
    if (contacts[i].distance < contacts[deepest].distance) deepest = i;
  }
  std::vector<uint32_t> chosen{deepest};
  choose_spread(places, kMostContacts, chosen);
  std::sort(chosen.begin(), chosen.end());
  std::vector<Contact> kept;
  for (uint32_t c : chosen) kept.push_back(contacts[c]);
  contacts = std::move(kept);
}

// The height of points of a body above a plane, m.
class Height {
 public:
  Height(const RigidMap& map, const Vec3& up, double level)
      : up_(glm::transpose(map.turn) * up), offset_(glm::dot(map.shift, up) - level) {}

  double operator()(const Vec3& p) const { return glm::dot(up_, p) + offset_; }
  // The height of the lowest corner of a box.
  double least(const Box& box) const {
    return (*this)(0.5 * (box.min + box.max)) - glm::dot(glm::abs(up_), 0.5 * (box.max - box.min));
  }

 private:
  Vec3 up_;  // in the frame of the body
  double offset_;
};

void warm_up(std::vector<Contact>& contacts, const PairMemory& memory) {
  for (Contact& c : contacts) {
    const auto at = std::ranges::lower_bound(memory.impulses, c.feature, {}, &ImpulseMemory::feature);
    if (at != memory.impulses.end() && at->feature == c.feature) c.impulse = at->impulse;
  }
}

void find_points_of_second(const MovingBody& first, const MovingBody& second, const ContactLengths& lengths,
                           PairMemory& memory, std::vector<Contact>& out) {
  const size_t before = out.size();
  find_point_contacts(second, first, lengths, memory.points_of_second, out);
  for (size_t i = before; i < out.size(); ++i) {
    Contact& c = out[i];
    c.at -= c.distance * c.normal;  // onto the first body
    c.normal = -c.normal;
    c.feature += kPointsOfSecond;
  }
}

}  // namespace

std::vector<Contact> find_contacts(const MovingBody& first, const MovingBody& second,
                                   const ContactLengths& lengths, PairMemory& memory) {
  KERF_ASSERT(first.id < second.id);
  if (memory.crossed > 0) {
    memory.points_of_first.clear();
    memory.points_of_second.clear();
    const std::optional<Contact> push = push_out(first, second, memory.crossed);
    return push ? std::vector{*push} : std::vector<Contact>{};
  }
  std::vector<Contact> contacts;
  find_point_contacts(first, second, lengths, memory.points_of_first, contacts);
  find_points_of_second(first, second, lengths, memory, contacts);
  find_chord_contacts(first, second, lengths, contacts);
  reduce(contacts);
  warm_up(contacts, memory);
  return contacts;
}

std::vector<Contact> find_ground_contacts(const MovingBody& body, const Surroundings& around,
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
  reduce(contacts);
  warm_up(contacts, memory);
  return contacts;
}

namespace {

// Forgets the point at a rim that made a contact, if one did.
void forget_at_rim(uint64_t feature, PairMemory& memory) {
  if (feature >> 32 != 0) return;
  const bool of_second = (feature & kPointsOfSecond) != 0;
  const auto point = static_cast<uint32_t>(of_second ? feature - kPointsOfSecond : feature);
  if (!is_at_rim(point)) return;
  std::erase_if(of_second ? memory.points_of_second : memory.points_of_first,
                [&](const PointMemory& m) { return m.point == point; });
}

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

}  // namespace kerf
