#include "ui/render/prepared_body.h"

namespace kerf {

PreparedBody prepare_shading(const Body& body) {
  const FloatFrame frame = FloatFrame::around(body.tree.bounds().min, body.tree.bounds().max);
  return {frame, BaseFaces(body.mesh, frame), nullptr};
}

PreparedBodies prepare_shading(const World& world) {
  PreparedBodies prepared;
  for (const BodyId id : world.ids()) prepared.emplace(id, prepare_shading(world.body(id)));
  return prepared;
}

void prepare_shadows(const World& world, PreparedBodies& prepared) {
  for (auto& [id, body] : prepared) {
    if (world.contains(id)) body.caster = std::make_unique<ShadowCaster>(world.body(id).mesh, body.frame);
  }
}

}  // namespace kerf
