#include "ui/gl/program.h"

#include <array>
#include <fstream>
#include <glm/gtc/type_ptr.hpp>
#include <sstream>
#include <utility>

#include "core/base/assert.h"

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

std::optional<std::string> read_text(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) return std::nullopt;
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

std::string joined(const std::vector<std::string>& names) {
  std::string all;
  for (size_t i = 0; i < names.size(); ++i) {
    all += (i ? ", " : "") + std::to_string(i) + " = " + names[i];
  }
  return all;
}

bool is_current_program(GLuint name) {
  GLint current = 0;
  glGetIntegerv(GL_CURRENT_PROGRAM, &current);
  return static_cast<GLuint>(current) == name;
}

// One stage of a program; must live until it is attached and linked.
class Shader {
 public:
  explicit Shader(GLenum stage) : name_(glCreateShader(stage)) {}
  ~Shader() { glDeleteShader(name_); }
  Shader(const Shader&) = delete;
  Shader& operator=(const Shader&) = delete;
  GLuint name() const { return name_; }

  Status compile(const std::filesystem::path& folder, const std::vector<std::string>& files,
                 const std::vector<std::string>& defines) {
    std::string source = "#version 330 core\n";
    for (const std::string& d : defines) source += "#define " + d + "\n";
    for (size_t i = 0; i < files.size(); ++i) {
      const std::optional<std::string> text = read_text(folder / files[i]);
      if (!text) return failed("the shader " + (folder / files[i]).string() + " cannot be read");
      source += "#line 1 " + std::to_string(i) + "\n" + *text + "\n";
    }
    const GLchar* chars = source.c_str();
    glShaderSource(name_, 1, &chars, nullptr);
    glCompileShader(name_);
    GLint ok = 0;
    glGetShaderiv(name_, GL_COMPILE_STATUS, &ok);
    if (ok) return Done{};
    std::array<GLchar, 2048> log{};
    glGetShaderInfoLog(name_, static_cast<GLsizei>(log.size()), nullptr, log.data());
    return failed("a shader does not compile (" + joined(files) + "): " + log.data());
  }

 private:
  GLuint name_;
};

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

Program::~Program() {
  if (name_ == 0) return;
  // Code that saves and restores the program in use, as Dear ImGui does, must not get the name of a deleted
  // one.
  if (is_current_program(name_)) glUseProgram(0);
  glDeleteProgram(name_);
}

Program::Program(Program&& other) noexcept : name_(std::exchange(other.name_, 0)) {}

Program& Program::operator=(Program&& other) noexcept {
  std::swap(name_, other.name_);
  return *this;
}

Result<Program> Program::load(const std::filesystem::path& folder, const ProgramFiles& files) {
  Shader vertex(GL_VERTEX_SHADER), fragment(GL_FRAGMENT_SHADER);
  if (Status s = vertex.compile(folder, files.vertex, files.defines); !s) return s.error();
  if (Status s = fragment.compile(folder, files.fragment, files.defines); !s) return s.error();
  Program program(glCreateProgram());
  glAttachShader(program.name_, vertex.name());
  glAttachShader(program.name_, fragment.name());
  glLinkProgram(program.name_);
  glDetachShader(program.name_, vertex.name());
  glDetachShader(program.name_, fragment.name());
  GLint ok = 0;
  glGetProgramiv(program.name_, GL_LINK_STATUS, &ok);
  if (ok) return program;
  std::array<GLchar, 2048> log{};
  glGetProgramInfoLog(program.name_, static_cast<GLsizei>(log.size()), nullptr, log.data());
  return failed("the shaders " + joined(files.vertex) + " and " + joined(files.fragment) +
                " do not link: " + log.data());
}

GLint Program::place_of(const char* uniform) const {
  KERF_ASSERT(is_current_program(name_));
  return glGetUniformLocation(name_, uniform);
}

void Program::set(const char* uniform, const glm::mat4& m) const {
  glUniformMatrix4fv(place_of(uniform), 1, GL_FALSE, glm::value_ptr(m));
}
void Program::set(const char* uniform, const glm::mat3& m) const {
  glUniformMatrix3fv(place_of(uniform), 1, GL_FALSE, glm::value_ptr(m));
}
void Program::set(const char* uniform, const glm::vec4& v) const {
  glUniform4fv(place_of(uniform), 1, glm::value_ptr(v));
}
void Program::set(const char* uniform, float x) const { glUniform1f(place_of(uniform), x); }
void Program::set(const char* uniform, int x) const { glUniform1i(place_of(uniform), x); }

void Program::set_texture(const char* uniform, int unit, GLuint texture, GLenum kind) const {
  set(uniform, unit);
  glActiveTexture(static_cast<GLenum>(GL_TEXTURE0 + unit));
  glBindTexture(kind, texture);
  glActiveTexture(GL_TEXTURE0);
}

void Program::bind_block(const char* block, GLuint binding) const {
  const GLuint index = glGetUniformBlockIndex(name_, block);
  if (index != GL_INVALID_INDEX) glUniformBlockBinding(name_, index, binding);
}

}  // namespace kerf::gl
