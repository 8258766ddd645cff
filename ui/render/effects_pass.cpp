#include "ui/render/effects_pass.h"

#include <algorithm>

#include "ui/render/body_picture.h"

namespace kerf {

namespace {

void attribute(GLuint index, GLint numbers, size_t stride, size_t offset) {
  glEnableVertexAttribArray(index);
  glVertexAttribPointer(index, numbers, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(stride),
                        reinterpret_cast<const void*>(offset));
}

}  // namespace

Result<EffectsPass> EffectsPass::create(const std::filesystem::path& shaders) {
  auto sparks = gl::Program::load(shaders, {{"frame.glsl", "particle.vert"}, {"frame.glsl", "spark.frag"}});
  if (!sparks) return sparks.error();
  auto smoke = gl::Program::load(shaders, {{"frame.glsl", "particle.vert"}, {"frame.glsl", "smoke.frag"}});
  if (!smoke) return smoke.error();
  return EffectsPass(std::move(*sparks), std::move(*smoke));
}

EffectsPass::EffectsPass(gl::Program sparks, gl::Program smoke)
    : sparks_(std::move(sparks)), smoke_(std::move(smoke)) {
  sparks_.bind_block("Frame", kFrameBlock);
  smoke_.bind_block("Frame", kFrameBlock);
  glBindVertexArray(layout_.name());
  glBindBuffer(GL_ARRAY_BUFFER, buffer_.name());
  attribute(0, 3, sizeof(Corner), offsetof(Corner, at));
  attribute(1, 3, sizeof(Corner), offsetof(Corner, towards));
  attribute(2, 2, sizeof(Corner), offsetof(Corner, across));
  attribute(3, 2, sizeof(Corner), offsetof(Corner, look));
}

void EffectsPass::draw(const Effects& effects, const FrameSpace& space) {
  if (effects.sparks.empty() && effects.puffs.empty()) return;
  glEnable(GL_BLEND);
  glDepthMask(GL_FALSE);
  glBindVertexArray(layout_.name());
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

void EffectsPass::add_quad(std::vector<Corner>& corners, Corner corner) {
  for (const glm::vec2 across : {glm::vec2(-1, -1), {1, -1}, {1, 1}, {-1, -1}, {1, 1}, {-1, 1}}) {
    corner.across = across;
    corners.push_back(corner);
  }
}

void EffectsPass::send(const std::vector<Corner>& corners) {
  glBindBuffer(GL_ARRAY_BUFFER, buffer_.name());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(corners.size() * sizeof(Corner)), corners.data(),
               GL_STREAM_DRAW);
  glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(corners.size()));
}

}  // namespace kerf
