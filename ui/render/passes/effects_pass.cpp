#include "ui/render/passes/effects_pass.h"

#include <algorithm>

#include "ui/render/bodies/body_picture.h"

namespace kerf {

EffectsPass::EffectsPass(Shaders& shaders)
    : sparks_(shaders.load({{"frame.glsl", "particle.vert"}, {"frame.glsl", "spark.frag"}})),
      smoke_(shaders.load({{"frame.glsl", "particle.vert"}, {"frame.glsl", "smoke.frag"}})),
      scorches_(shaders.load({{"frame.glsl", "scorch.vert"}, {"scorch.frag"}})) {}

void EffectsPass::draw(const Effects& effects, const FrameSpace& space) {
  if (effects.sparks.empty() && effects.puffs.empty() && effects.scorches.empty()) return;
  glEnable(GL_BLEND);
  glDepthMask(GL_FALSE);
  draw_scorches(effects.scorches, space);
  draw_smoke(effects.puffs, space);
  draw_sparks(effects.sparks, space);
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
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
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE_MINUS_SRC_ALPHA);
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
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_COLOR);
  sparks_.use();
  send(corners);
}

// They darken what lies under them, and then glow.
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
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(-2, -8);
  scorches_.use();
  scorches_.set("glow", 0);
  glBlendFuncSeparate(GL_ZERO, GL_SRC_COLOR, GL_ZERO, GL_ONE);
  send(corners);
  scorches_.set("glow", 1);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_COLOR);
  send(corners);
  glDisable(GL_POLYGON_OFFSET_FILL);
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
