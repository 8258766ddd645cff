#include "core/physics/contact/contact.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/random.h"

namespace kerf {
namespace {

constexpr Vec3 kUp(0, 1, 0);

// Contacts at these places of the ground, with depths between 0 and `deepest`.
std::vector<Contact> random_contacts(size_t count, const Vec3& extent, double deepest, Random& random) {
  std::vector<Contact> contacts(count);
  for (uint32_t i = 0; i < count; ++i) {
    contacts[i].at = extent * Vec3(random.unit(), 0, random.unit());
    contacts[i].distance = -deepest * random.unit();
    contacts[i].feature = i;
  }
  return contacts;
}

TEST(ReducedContacts, are_eight_in_order_including_the_deepest) {
  Random random(1);
  for (int turn = 0; turn < 50; ++turn) {
    for (const bool on_plane : {false, true}) {
      std::vector<Contact> contacts = random_contacts(100, {1, 0, 1}, 0.001, random);
      const auto deepest = std::ranges::min_element(contacts, {}, &Contact::distance)->feature;
      on_plane ? reduce_on_plane(contacts, kUp, 0) : reduce_contacts(contacts);
      EXPECT_LE(contacts.size(), kMaxContacts);
      EXPECT_TRUE(std::ranges::is_sorted(contacts, {}, &Contact::feature));
      EXPECT_TRUE(std::ranges::any_of(contacts, [&](const Contact& c) { return c.feature == deepest; }));
    }
  }
}

TEST(ReducedContacts, of_four_wheels_keep_the_lowest_point_of_each) {
  Random random(2);
  std::vector<Contact> contacts;
  std::vector<uint64_t> lowest;
  for (const Vec3 wheel : {Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(0, 0, 4), Vec3(2, 0, 4)}) {
    lowest.push_back(contacts.size() + 7);
    for (uint32_t i = 0; i < 15; ++i) {
      Contact& c = contacts.emplace_back();
      c.at = wheel + Vec3(0.02 * i, 0, 0.1 * random.unit());
      c.distance = 1e-4 * std::abs(static_cast<int>(i) - 7);
      c.feature = contacts.size() - 1;
    }
  }
  reduce_on_plane(contacts, kUp, 0);
  for (const uint64_t feature : lowest) {
    EXPECT_TRUE(std::ranges::any_of(contacts, [&](const Contact& c) { return c.feature == feature; }))
        << feature;
  }
}

TEST(ReducedContacts, stay_until_another_is_much_deeper) {
  Random random(4);
  std::vector<Contact> contacts = random_contacts(100, {1, 0, 1}, 1e-5, random);
  std::vector<Contact> first = contacts;
  reduce_on_plane(first, kUp, 1e-4);
  for (const Contact& c : first) contacts[c.feature].impulse[0] = 1;
  for (Contact& c : contacts) c.distance = -1e-5 * random.unit();
  reduce_on_plane(contacts, kUp, 1e-4);
  size_t same = 0;
  for (const Contact& c : contacts) same += c.impulse[0] > 0;
  EXPECT_GE(same, 6u) << "of eight";
}

TEST(ReducedContacts, of_a_needle_lie_on_both_sides) {
  Random random(3);
  for (int turn = 0; turn < 50; ++turn) {
    std::vector<Contact> contacts = random_contacts(100, {1, 0, 0.004}, 0.001, random);
    reduce_on_plane(contacts, kUp, 0);
    const auto [left, right] =
        std::ranges::minmax_element(contacts, {}, [](const Contact& c) { return c.at.z; });
    EXPECT_LT(left->at.z, 0.0015);
    EXPECT_GT(right->at.z, 0.0025);
  }
}

}  // namespace
}  // namespace kerf
