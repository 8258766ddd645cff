#include "ui/render/prepared_body.h"

namespace kerf {

namespace {

constexpr double kShading = 0.5;  // of the time; the rest is the shadows

Result<PreparedBody> prepare_body(const Body& body, const Progress& progress) {
  const Progress shading = share_of(&progress, 0, kShading), shadows = share_of(&progress, kShading, 1);
  const FloatFrame frame = picture_frame(body);
  Result<BaseFaces> bases = BaseFaces::build(body.mesh, frame, &shading);
  if (!bases) return bases.error();
  Result<ShadowCaster> caster = ShadowCaster::build(body.mesh, frame, &shadows);
  if (!caster) return caster.error();
  return PreparedBody{frame, std::move(*bases), std::make_unique<ShadowCaster>(std::move(*caster))};
}

}  // namespace

Result<PreparedBodies> prepare_bodies(const World& world, const Progress* progress) {
  PreparedBodies prepared;
  Stages stages(progress);
  for (const BodyId id : world.ids()) {
    const Body& body = world.body(id);
    const double share =
        static_cast<double>(body.mesh.live_faces()) / static_cast<double>(world.live_faces());
    const Progress preparing = stages.next(share);
    Result<PreparedBody> made = prepare_body(body, preparing);
    if (!made) return made.error();
    prepared.emplace(id, std::move(*made));
  }
  return prepared;
}

}  // namespace kerf
