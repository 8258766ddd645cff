#include "core/physics/contact/contact.h"

#include <algorithm>

#include "core/base/assert.h"
#include "core/physics/contact/collider_features.h"
#include "core/physics/contact/point_contacts.h"

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

namespace {

// Height at which a contact is ranked.
struct Rank {
  double bonus = 0;
  double operator()(const Contact& c) const { return c.distance - (c.impulse[0] > 0 ? bonus : 0); }
};

uint32_t deepest_of(const std::vector<Contact>& contacts, const Rank& rank = {}) {
  const auto deepest = std::ranges::min_element(contacts, {}, rank);
  return static_cast<uint32_t>(deepest - contacts.begin());
}

// Keeps the selected contacts, in the order in which they were found.
void keep(std::vector<Contact>& contacts, std::vector<uint32_t> selected) {
  std::ranges::sort(selected);
  std::vector<Contact> kept;
  for (const uint32_t c : selected) kept.push_back(contacts[c]);
  contacts = std::move(kept);
}

}  // namespace

void reduce_contacts(std::vector<Contact>& contacts) {
  if (contacts.size() <= kMaxContacts) return;
  std::vector<Vec3> places;
  for (const Contact& c : contacts) places.push_back(c.at);
  std::vector<uint32_t> selected{deepest_of(contacts)};
  select_spread_points(places, kMaxContacts, selected);
  keep(contacts, std::move(selected));
}

namespace {

// Returns positions of contacts on a plane, along the longest distance and across it, relative to extents.
std::vector<Vec3> places_on_plane(const std::vector<Contact>& contacts, uint32_t from, const Vec3& up) {
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

}  // namespace

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

}  // namespace kerf
