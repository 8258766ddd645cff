#pragma once

#include <deque>
#include <vector>

#include "core/physics/contact/rigid_body.h"
#include "core/world/world.h"

namespace kerf::test {

// Sheets as the stages of a tick see them: each goes straight on by its velocity, without gravity, and turns
// by its spin.
class MovingSheets {
 public:
  // Adds a sheet and returns its index.
  uint32_t add(const Soup& soup, const Vec3& position, const glm::dquat& orientation = {1, 0, 0, 0});
  Body& body(uint32_t i) { return world.body(world.ids()[i]); }
  // The bodies at the beginning of a tick. To be asked anew after a change; then what was returned before is
  // void.
  std::vector<MovingBody>& bodies();
  // Moves the bodies to where MovingBody::next says that they go.
  void move_on();

  World world;

 private:
  std::deque<Collider> colliders_;
  std::vector<MovingBody> bodies_;
};

}  // namespace kerf::test
