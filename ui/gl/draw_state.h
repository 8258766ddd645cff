#pragma once

#include <epoxy/gl.h>

#include <glm/vec4.hpp>
#include <optional>

namespace kerf::gl {

// The factors by which a colour that is drawn and the colour that is there are added, for the three colour
// channels and for alpha.
struct Blend {
  GLenum drawn = GL_ONE, there = GL_ZERO, drawn_alpha = GL_ONE, there_alpha = GL_ZERO;
};
inline constexpr Blend kAdd{GL_ONE, GL_ONE, GL_ONE, GL_ONE};
// Brightens what is there without exceeding white.
inline constexpr Blend kScreen{GL_ONE, GL_ONE_MINUS_SRC_COLOR, GL_ONE, GL_ONE_MINUS_SRC_COLOR};
// Lays what is drawn over what is there by its opacity. The alpha of a picture is the share of its light that
// blooms, which what is laid over it takes away like the light itself.
inline constexpr Blend kOver{GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE_MINUS_SRC_ALPHA};

// The comparison of a reference value with the stencil, and how the stencil changes: where the depth test
// fails, for front and back faces, and where everything passes.
struct Stencil {
  GLenum test = GL_ALWAYS;
  GLint reference = 0;
  GLenum front_behind = GL_KEEP, back_behind = GL_KEEP;
  GLenum passed = GL_KEEP;
};

// The factor and the units of glPolygonOffset.
struct DepthOffset {
  float per_slope = 0, units = 0;
};

// The fixed state with which a pass draws. The default is that of opaque surfaces without a stencil.
struct State {
  GLenum depth = GL_LESS;     // the comparison; GL_NONE: depth is neither tested nor written
  bool writes_depth = true;   // no effect without a comparison
  bool clamps_depth = false;  // draws what lies before the near plane and beyond the far plane
  GLenum culled = GL_NONE;    // the sides that are not drawn
  bool writes_colour = true, writes_alpha = true;
  std::optional<Blend> blend = {};
  std::optional<DepthOffset> offset = {};
  std::optional<Stencil> stencil = {};
};

// Draws with a state to the end of the scope, which sets that of the enclosing scope again, or State() where
// there is none. Scissors, clip distances and sample masks are no part of it.
class ScopedState {
 public:
  explicit ScopedState(const State& state);
  ~ScopedState();
  ScopedState(const ScopedState&) = delete;
  ScopedState& operator=(const ScopedState&) = delete;

  // Replaces the state for the rest of the scope.
  void set(const State& state);

 private:
  State outer_;
};

// Sets State() and switches the scissor test off, whatever others have set. Precondition: no ScopedState
// exists on this thread.
void reset_state();

// Fills a rectangle of the bound framebuffer, in pixels from its lower left corner. Leaves the scissor test
// off.
void fill(int x, int y, int width, int height, const glm::vec4& colour);

}  // namespace kerf::gl
