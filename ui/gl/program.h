#pragma once

#include <epoxy/gl.h>
#include <filesystem>
#include <glm/glm.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace kerf::gl {

// Blend factors of the source (`drawn`) and the destination (`there`), for the colour channels and for
// alpha.
struct Blend {
  GLenum drawn = GL_ONE, there = GL_ZERO, drawn_alpha = GL_ONE, there_alpha = GL_ZERO;
};
inline constexpr Blend kAdd{GL_ONE, GL_ONE, GL_ONE, GL_ONE};
// Brightens the destination without exceeding white.
inline constexpr Blend kScreen{GL_ONE, GL_ONE_MINUS_SRC_COLOR, GL_ONE, GL_ONE_MINUS_SRC_COLOR};
// Blends the source over the destination by its opacity. The alpha of a frame is the share of its light
// that blooms, which a layer above attenuates like the light itself.
inline constexpr Blend kOver{GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE_MINUS_SRC_ALPHA};

// The stencil test and its operations: on a failed depth test, for front and back faces, and on a pass.
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

// The fixed-function state of a pass. The default suits opaque surfaces without a stencil.
struct State {
  GLenum depth = GL_LESS;     // comparison; GL_NONE: no depth test and no depth writes
  bool writes_depth = true;   // no effect without a comparison
  bool clamps_depth = false;  // draws geometry in front of the near plane and beyond the far plane
  GLenum culled = GL_NONE;    // culled side
  bool writes_colour = true, writes_alpha = true;
  std::optional<Blend> blend = {};
  std::optional<DepthOffset> offset = {};
  std::optional<Stencil> stencil = {};
};

// Applies a state until the end of the scope, then restores that of the enclosing scope, or State() in the
// outermost one. Excludes scissors, clip distances and sample masks.
class ScopedState {
 public:
  explicit ScopedState(const State& state);
  ~ScopedState();
  ScopedState(const ScopedState&) = delete;
  ScopedState& operator=(const ScopedState&) = delete;

  void set(const State& state);

 private:
  State outer_;
};

// Applies State() and disables the scissor test, whatever other code has set. Precondition: no ScopedState
// exists on this thread.
void reset_state();

// Fills a rectangle of the bound framebuffer, in pixels from its lower left corner. Leaves the scissor test
// disabled.
void fill(int x, int y, int width, int height, const glm::vec4& colour);

// The source files of a program. The files of each stage are concatenated in the given order after the line
// "#version 330 core".
struct ProgramFiles {
  std::vector<std::string> vertex;
  std::vector<std::string> fragment;
  std::vector<std::string> defines = {};
};

// A linked vertex and fragment program of the current context.
class Program {
 public:
  Program() = default;
  ~Program();
  Program(Program&& other) noexcept;
  Program& operator=(Program&& other) noexcept;
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  // Reads, compiles and links the files. The error names the file and the line as reported by the driver.
  static Result<Program> load(const std::filesystem::path& folder, const ProgramFiles& files);

  void use() const { glUseProgram(name_); }
  GLuint name() const { return name_; }

  // Set a uniform. Ignore a name that the compiler has removed. Precondition: the program is in use.
  void set(const char* uniform, const glm::mat4& m) const;
  void set(const char* uniform, const glm::mat3& m) const;
  void set(const char* uniform, const glm::vec4& v) const;
  void set(const char* uniform, float x) const;
  void set(const char* uniform, int x) const;
  // Binds a texture to a unit, and the sampler to that unit. Leaves unit 0 active. Precondition: as for
  // set().
  void set_texture(const char* uniform, int unit, GLuint texture, GLenum kind = GL_TEXTURE_2D) const;
  void bind_block(const char* block, GLuint binding) const;

 private:
  explicit Program(GLuint name) : name_(name) {}
  GLint place_of(const char* uniform) const;
  GLuint name_ = 0;
};

}  // namespace kerf::gl
