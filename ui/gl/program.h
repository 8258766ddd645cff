#pragma once

#include <epoxy/gl.h>

#include <filesystem>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace kerf::gl {

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
