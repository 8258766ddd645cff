#include "core/world/body_state.h"

#include "core/world/world.h"

namespace kerf {

std::vector<BodyState> moved_bodies(const World& world) {
  std::vector<BodyState> states;
  for (const BodyId id : world.ids()) {
    const Body& body = world.body(id);
    if (body.motion != Motion{}) states.push_back({id, body.placement, body.motion});
  }
  return states;
}

}  // namespace kerf
