#include "core/physics/contact/contact.h"

#include <gtest/gtest.h>

#include "core/physics/contact/penetration.h"

namespace kerf {
namespace {

// A point at a rim, and one that is not, of each body of a pair.
class RememberedPoints : public testing::Test {
 protected:
  static constexpr uint32_t kRimPoint = kOnChord | kAtRim | 5, kPoint = 7;

  RememberedPoints() {
    for (auto* points : {&memory_.points_of_first, &memory_.points_of_second})
      *points = {{kPoint, {0, 1, 0}}, {kRimPoint, {0, 1, 0}}};
  }
  // A contact that this point of the first body, or the second, found.
  static Contact contact(uint32_t point, bool of_second, double pressed) {
    Contact c;
    c.feature = point + (of_second ? kOnSecond : 0);
    c.impulse[0] = pressed;
    return c;
  }

  PairMemory memory_;
};

TEST_F(RememberedPoints, at_rims_are_dropped_from_their_body_if_unloaded) {
  for (const bool of_second : {false, true}) {
    PairMemory memory = memory_;
    remember_impulses({contact(kRimPoint, of_second, 0), contact(kPoint, of_second, 0)}, memory);
    EXPECT_EQ(memory.points_of_first.size(), of_second ? 2u : 1u);
    EXPECT_EQ(memory.points_of_second.size(), of_second ? 1u : 2u);
    EXPECT_FALSE(memory.touching);
  }
}

TEST_F(RememberedPoints, persist_with_their_impulses_if_loaded) {
  std::vector<Contact> contacts{contact(kRimPoint, true, 3), contact(kRimPoint, false, 2),
                                contact(kPoint, false, 0)};
  remember_impulses(contacts, memory_);
  EXPECT_TRUE(memory_.touching);
  EXPECT_EQ(memory_.points_of_first.size(), 2u);
  EXPECT_EQ(memory_.points_of_second.size(), 2u);
  for (Contact& c : contacts) c.impulse[0] = 0;
  take_impulses(memory_, contacts);
  EXPECT_EQ(contacts[0].impulse[0], 3);
  EXPECT_EQ(contacts[1].impulse[0], 2);
  EXPECT_EQ(contacts[2].impulse[0], 0);
}

}  // namespace
}  // namespace kerf
