#pragma once

#include <optional>
#include <set>
#include <vector>

#include "core/physics/contact/collider.h"
#include "core/physics/contact/contact.h"
#include "core/physics/contact/rigid_body.h"

namespace kerf {

// Returns the corners of the walls of a solid body, sorted by position; empty for a sheet. O(n log n) in the
// walls, and O(faces).
std::vector<WallCorner> wall_corners(const Body& body);

// Returns the labels of the pieces of a body that mate with another piece of it: their walls share corners,
// and face each other there. O(n log n) in the walls, and O(faces).
std::set<uint32_t> mating_labels(const Body& body);

// The geometry of a pair of bodies for contacts. The walls of two bodies mate if they share corners, to the
// bit and in the frames of the bodies, and face each other there: a knife separated the bodies. Mating walls
// may touch, because no skin is kept between them (see ContactLengths).
//
// While the planes of all mating walls coincide up to half a skin, the first body counts as moved off the
// second one by a skin. If also all mating corners lie that near to each other, these are the contacts.
class PairGeometry {
 public:
  // Preconditions: first.id < second.id, and both outlive this object. O(corners of walls).
  PairGeometry(const MovingBody& first, const MovingBody& second);

  // Returns the first body, moved off the second one if their walls mate.
  const MovingBody& first() const { return apart_ ? *apart_ : *first_; }
  const MovingBody& second() const { return *second_; }

  // See sheets_cross(), pass_through() and find_contacts().
  bool cross() const;
  bool pass_through() const;
  std::vector<Contact> contacts(PairMemory& memory) const;

 private:
  void move_apart(double skin);
  // Returns true if the mating walls enclose the first body, so that no direction leads off all of them.
  bool is_enclosed() const { return !mating_.empty() && !apart_; }

  const MovingBody* first_;
  const MovingBody* second_;
  std::vector<WallCorner> mating_;  // of the second body; empty if the walls do not mate
  bool seated_ = false;             // the mating corners lie near each other
  std::optional<MovingBody> apart_;
  Vec3 way_apart_{0};  // in world coordinates
};

}  // namespace kerf
