#include <cmath>

#include "core/base/assert.h"
#include "ui/render/renderer.h"
#include "ui/render/view/drawn_ground.h"

namespace kerf {

namespace {
constexpr double kGlowWidth = 1.0 / 220;  // of the diagonal of the world as loaded
}

void Renderer::show(const World& world, const std::map<std::string, Paint>& paints, PreparedBodies prepared) {
  bodies_.clear();
  heat_of_.reset();
  paints_ = paints;
  passes_.lines.forget();
  passes_.scene.shadows().forget();
  contact_old_ = true;
  const World::Bounds bounds = world.loaded_bounds();
  const double diagonal = bounds.diagonal();
  glow_width_ = kGlowWidth * diagonal;
  loaded_.clear();
  smooth_.clear();
  for (const auto& [id, body] : prepared) loaded_.emplace(id, LoadedShading{body.frame, body.bases});
  for (const BodyId id : world.ids()) {
    PreparedBody ahead = prepare_shading(world.body(id), loaded_);
    ahead.caster = std::move(prepared[id].caster);
    prepared[id] = std::move(ahead);
    add(id, world.body(id), prepared);
  }
  middle_ = bounds.min + (bounds.max - bounds.min) * 0.5;
  space_.unit = diagonal > 0 && std::isfinite(diagonal) ? std::ldexp(1.0, std::ilogb(diagonal)) : 1;
  place_ground(world);
}

void Renderer::place_ground(const World& world) {
  passes_.scene.ground().place_under(world.loaded_bounds(), space_.up,
                                     height_of_drawn_ground(world, space_.up));
}

void Renderer::add(BodyId id, const Body& body, PreparedBodies& prepared) {
  KERF_ASSERT(!bodies_.contains(id));
  const auto found = prepared.find(id);
  PreparedBody ahead = found != prepared.end() ? std::move(found->second) : prepare_shading(body, loaded_);
  if (body.loaded_faces.empty()) loaded_.try_emplace(body.loaded_as, LoadedShading{ahead.frame, ahead.bases});
  if (ahead.caster) passes_.scene.shadows().adopt(id, std::move(ahead.caster));
  bodies_.emplace(id, BodyPicture(body, paints_, std::move(ahead), glow_width_));
}

void Renderer::take_casters(PreparedBodies prepared) {
  for (auto& [id, body] : prepared) {
    KERF_ASSERT(bodies_.contains(id));
    if (body.caster) passes_.scene.shadows().adopt(id, std::move(body.caster));
  }
}

void Renderer::drop(BodyId id) {
  bodies_.erase(id);
  passes_.lines.forget(id);
  passes_.scene.shadows().forget(id);
}

void Renderer::carry_on(BodyId from, BodyId to) {
  const auto found = bodies_.find(from);
  if (found == bodies_.end()) return;  // the body came later in the same delta
  bodies_.insert_or_assign(to, std::move(found->second));
  bodies_.erase(found);
  passes_.lines.forget(from);
  passes_.lines.forget(to);
  passes_.scene.shadows().carry_on(from, to);
}

void Renderer::follow(const World& world, const Delta& delta, PreparedBodies prepared) {
  if (delta.anew) return resend(world, std::move(prepared));
  if (delta.empty()) return;
  for (const BodyId id : delta.went) drop(id);
  for (const Detached& d : delta.detached) {
    if (d.carries_on) carry_on(d.from, d.to);
  }
  for (const BodyId id : delta.came) add(id, world.body(id), prepared);
  for (const BodyDelta& d : delta.bodies) {
    const auto found = bodies_.find(d.body);
    if (found != bodies_.end()) found->second.faces().follow(d);
    passes_.lines.forget(d.body);
  }
  passes_.scene.shadows().follow(delta);
  if (delta.environment) place_ground(world);
  contact_old_ = true;
}

void Renderer::resend(const World& world, PreparedBodies prepared) {
  heat_of_.reset();
  std::erase_if(bodies_, [&](const auto& body) { return !world.contains(body.first); });
  passes_.scene.shadows().forget();
  for (const BodyId id : world.ids()) {
    const auto found = bodies_.find(id);
    if (found == bodies_.end()) {
      add(id, world.body(id), prepared);
      continue;
    }
    found->second.faces().forget_all(world.body(id).mesh);
    const auto ahead = prepared.find(id);
    if (ahead != prepared.end() && ahead->second.caster)
      passes_.scene.shadows().adopt(id, std::move(ahead->second.caster));
  }
  place_ground(world);
  contact_old_ = true;
  passes_.lines.forget();
}

}  // namespace kerf
