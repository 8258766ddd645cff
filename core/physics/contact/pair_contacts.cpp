#include "core/physics/contact/pair_contacts.h"

#include <algorithm>
#include <cassert>

#include "core/physics/collider/spread_points.h"
#include "core/physics/contact/chord_contacts.h"
#include "core/physics/contact/point_contacts.h"

namespace kerf {

namespace {

constexpr size_t kMostContacts = 16;
constexpr uint64_t kPointsOfSecond = uint64_t{1} << 31;  // added to the features of contacts found by them

// The deepest contact, and then those that lie farthest apart, in the order in which they were found.
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

void warm_up(std::vector<Contact>& contacts, const PairMemory& memory) {
  for (Contact& c : contacts) {
    const auto at = std::lower_bound(memory.impulses.begin(), memory.impulses.end(), c.feature,
                                     [](const ImpulseMemory& m, uint64_t f) { return m.feature < f; });
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
  assert(first.id < second.id);
  if (memory.crossed) {
    memory.points_of_first.clear();
    memory.points_of_second.clear();
    return {};
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
  const Vec3 up = around.up();
  const double skin = lengths.ground_skin * body.scale, reach = lengths.reach * body.scale;
  for (uint32_t i = 0; i < body.collider->points.size(); ++i) {
    const Vec3& p = body.collider->points[i].at;
    const Vec3 at = body.now(p);
    const double distance = glm::dot(at, up) - *around.ground - skin;
    const double next = glm::dot(body.next(p), up) - *around.ground - skin;
    if (std::min(distance, next) > reach) continue;
    contacts.push_back({at, up, distance, i, {}});
  }
  reduce(contacts);
  warm_up(contacts, memory);
  return contacts;
}

void remember_impulses(const std::vector<Contact>& contacts, PairMemory& memory) {
  memory.impulses.clear();
  memory.touching = false;
  for (const Contact& c : contacts) {
    if (c.impulse[0] == 0) continue;
    memory.impulses.push_back({c.feature, c.impulse});
    memory.touching = true;
  }
  std::sort(memory.impulses.begin(), memory.impulses.end(),
            [](const ImpulseMemory& a, const ImpulseMemory& b) { return a.feature < b.feature; });
}

}  // namespace kerf
