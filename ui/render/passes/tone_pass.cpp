#include "ui/render/passes/tone_pass.h"

#include "core/base/assert.h"
#include "ui/gl/state.h"

namespace kerf {

TonePass::TonePass(Shaders& shaders)
    : one_sample_(shaders.load({{"screen.vert"}, {"frame.glsl", "light.glsl", "tone.frag"}})),
      samples_(shaders.load({{"screen.vert"}, {"frame.glsl", "light.glsl", "tone.frag"}, {"SAMPLES"}})) {}

void TonePass::draw(const gl::Framebuffer& scene, const gl::Framebuffer& to) const {
  KERF_ASSERT(scene.shape().width == to.shape().width && scene.shape().height == to.shape().height &&
              scene.shape().samples == to.shape().samples);
  const int count = scene.shape().samples;
  const gl::Program& program = count > 1 ? samples_ : one_sample_;
  to.bind();
  const gl::ScopedState state({.depth = GL_NONE});
  program.use();
  const GLenum kind = count > 1 ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D;
  program.set_texture("scene", 0, scene.colour_texture(), kind);
  if (count > 1) glEnable(GL_SAMPLE_MASK);
  for (int i = 0; i < count; ++i) {
    if (count > 1) glSampleMaski(0, 1u << i);
    program.set("which", i);
    no_vertices_.draw_screen();
  }
  if (count > 1) {
    glSampleMaski(0, ~0u);
    glDisable(GL_SAMPLE_MASK);
  }
}

}  // namespace kerf
