#include "ui/render/passes/effects_pass.h"

#include <algorithm>

#include "ui/gl/state.h"

namespace kerf {

EffectsPass::EffectsPass(Shaders& shaders)
    : sparks_(shaders.load({{"frame.glsl", "particle.vert"}, {"frame.glsl", "spark.frag"}})),
      smoke_(shaders.load({{"frame.glsl", "particle.vert"}, {"frame.glsl", "smoke.frag"}})),
      scorches_(shaders.load({{"frame.glsl", "scorch.vert"}, {"scorch.frag"}})) {}

void EffectsPass::draw(const Effects& effects, const FrameSpace& space) {
  draw_scorches(effects.scorches, space);
  draw_smoke(effects.puffs, space);
  draw_sparks(effects.sparks, space);
}

// Alpha is the share of light that blooms: smoke takes it away like the light itself.
void EffectsPass::draw_smoke(const std::vector<Puff>& puffs, const FrameSpace& space) {
  if (puffs.empty()) return;
  std::vector<std::pair<double, const Puff*>> far_first;
  for (const Puff& puff : puffs) far_first.emplace_back(-glm::length(puff.at - space.seen_from), &puff);
  std::stable_sort(far_first.begin(), far_first.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Corner> corners;
  for (const auto& [distance, puff] : far_first) {
    const glm::vec3 at = space.from_world(puff->at);
    add_quad(
        corners,
        {at, at, {}, {space.length(puff->radius), static_cast<float>(std::clamp(puff->opacity, 0.0, 1.0))}});
  }
  const gl::ScopedState state({.writes_depth = false, .blend = gl::kOver});
  smoke_.use();
  send(corners);
}

void EffectsPass::draw_sparks(const std::vector<Spark>& sparks, const FrameSpace& space) {
  if (sparks.empty()) return;
  std::vector<Corner> corners;
  for (const Spark& spark : sparks)
    add_quad(corners, {space.from_world(spark.at),
                       space.from_world(spark.tail),
                       {},
                       {space.length(spark.width), static_cast<float>(std::clamp(spark.heat, 0.0, 1.0))}});
  const gl::ScopedState state({.writes_depth = false, .blend = gl::kScreen});
  sparks_.use();
  send(corners);
}

// Scorches darken the surface under them first; then their glow is added.
void EffectsPass::draw_scorches(const std::vector<Scorch>& scorches, const FrameSpace& space) {
  if (scorches.empty()) return;
  std::vector<Corner> corners;
  for (const Scorch& s : scorches) {
    const Vec3 beside = std::abs(s.normal.y) < 0.9 ? Vec3(0, 1, 0) : Vec3(1, 0, 0);
    const Vec3 right = glm::normalize(glm::cross(beside, s.normal)) * s.radius;
    const Vec3 up = glm::cross(s.normal, right);
    const size_t first = corners.size();
    add_quad(corners, {{}, {}, {}, {0, static_cast<float>(std::clamp(s.heat, 0.0, 1.0))}});
    for (size_t i = first; i < corners.size(); ++i) {
      const Vec3 corner = s.at + right * double{corners[i].across.x} + up * double{corners[i].across.y};
      corners[i].at = corners[i].towards = space.from_world(corner);
    }
  }
  constexpr gl::Blend kDarken{GL_ZERO, GL_SRC_COLOR, GL_ZERO, GL_ONE};
  constexpr gl::DepthOffset kBefore{-2, -8};
  scorches_.use();
  gl::ScopedState state({.writes_depth = false, .blend = kDarken, .offset = kBefore});
  scorches_.set("glow", 0);
  send(corners);
  state.set({.writes_depth = false, .blend = gl::kScreen, .offset = kBefore});
  scorches_.set("glow", 1);
  send(corners);
}

void EffectsPass::add_quad(std::vector<Corner>& corners, Corner corner) {
  for (const glm::vec2 across : {glm::vec2(-1, -1), {1, -1}, {1, 1}, {-1, -1}, {1, 1}, {-1, 1}}) {
    corner.across = across;
    corners.push_back(corner);
  }
}

void EffectsPass::send(const std::vector<Corner>& corners) {
  corners_.send(corners);
  glDrawArrays(GL_TRIANGLES, 0, corners_.count());
}

}  // namespace kerf
