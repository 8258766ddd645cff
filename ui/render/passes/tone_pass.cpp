#include "ui/render/passes/tone_pass.h"

#include "core/base/assert.h"
#include "ui/render/bodies/body_picture.h"

namespace kerf {

Result<TonePass> TonePass::create(const std::filesystem::path& shaders) {
  gl::ProgramFiles files{{"screen.vert"}, {"frame.glsl", "light.glsl", "tone.frag"}};
  auto one_sample = gl::Program::load(shaders, files);
  if (!one_sample) return one_sample.error();
  files.defines = {"SAMPLES"};
  auto samples = gl::Program::load(shaders, files);
  if (!samples) return samples.error();
  return TonePass(std::move(*one_sample), std::move(*samples));
}

TonePass::TonePass(gl::Program one_sample, gl::Program samples)
    : one_sample_(std::move(one_sample)), samples_(std::move(samples)) {
  for (const gl::Program* p : {&one_sample_, &samples_}) p->bind_block("Frame", kFrameBlock);
}

void TonePass::draw(const gl::Framebuffer& scene, const gl::Framebuffer& to) const {
  KERF_ASSERT(scene.shape().width == to.shape().width && scene.shape().height == to.shape().height &&
              scene.shape().samples == to.shape().samples);
  const int count = scene.shape().samples;
  const gl::Program& program = count > 1 ? samples_ : one_sample_;
  to.bind();
  glDisable(GL_DEPTH_TEST);
  program.use();
  program.set("scene", 0);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(count > 1 ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D, scene.colour_texture());
  glBindVertexArray(no_vertices_.name());
  if (count > 1) glEnable(GL_SAMPLE_MASK);
  for (int i = 0; i < count; ++i) {
    if (count > 1) glSampleMaski(0, 1u << i);
    program.set("which", i);
    glDrawArrays(GL_TRIANGLES, 0, 3);
  }
  if (count > 1) {
    glSampleMaski(0, ~0u);
    glDisable(GL_SAMPLE_MASK);
  }
  glEnable(GL_DEPTH_TEST);
}

}  // namespace kerf
