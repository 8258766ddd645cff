#include "ui/render/prepared_body.h"

namespace kerf {

PreparedBodies prepare_bodies(const World& world) {
  PreparedBodies prepared;
  for (const BodyId id : world.ids()) {
    const Body& body = world.body(id);
    const FloatFrame frame = picture_frame(body);
    prepared.emplace(id, PreparedBody{frame, BaseFaces(body.mesh, frame),
                                      std::make_unique<ShadowCaster>(body.mesh, frame)});
  }
  return prepared;
}

}  // namespace kerf
