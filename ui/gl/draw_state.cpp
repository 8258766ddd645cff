#include "ui/gl/draw_state.h"

namespace kerf::gl {

namespace {

thread_local State in_force;  // of the innermost scope

void enable(GLenum capability, bool on) {
  if (on) glEnable(capability);
  if (!on) glDisable(capability);
}

void apply(const State& state) {
  in_force = state;
  enable(GL_DEPTH_TEST, state.depth != GL_NONE);
  if (state.depth != GL_NONE) glDepthFunc(state.depth);
  glDepthMask(state.writes_depth);
  enable(GL_DEPTH_CLAMP, state.clamps_depth);
  enable(GL_CULL_FACE, state.culled != GL_NONE);
  glCullFace(state.culled != GL_NONE ? state.culled : GL_BACK);
  glColorMask(state.writes_colour, state.writes_colour, state.writes_colour, state.writes_alpha);
  enable(GL_BLEND, state.blend.has_value());
  if (const auto& b = state.blend) glBlendFuncSeparate(b->drawn, b->there, b->drawn_alpha, b->there_alpha);
  enable(GL_POLYGON_OFFSET_FILL, state.offset.has_value());
  if (state.offset) glPolygonOffset(state.offset->per_slope, state.offset->units);
  enable(GL_STENCIL_TEST, state.stencil.has_value());
  if (const auto& s = state.stencil) {
    glStencilFunc(s->test, s->reference, 0xff);
    glStencilOpSeparate(GL_FRONT, GL_KEEP, s->front_behind, s->passed);
    glStencilOpSeparate(GL_BACK, GL_KEEP, s->back_behind, s->passed);
  }
}

}  // namespace

ScopedState::ScopedState(const State& state) : outer_(in_force) { apply(state); }

ScopedState::~ScopedState() { apply(outer_); }

void ScopedState::set(const State& state) { apply(state); }

void reset_state() {
  glDisable(GL_SCISSOR_TEST);
  apply({});
}

void fill(int x, int y, int width, int height, const glm::vec4& colour) {
  glEnable(GL_SCISSOR_TEST);
  glScissor(x, y, width, height);
  glClearColor(colour.r, colour.g, colour.b, colour.a);
  glClear(GL_COLOR_BUFFER_BIT);
  glDisable(GL_SCISSOR_TEST);
}

}  // namespace kerf::gl
