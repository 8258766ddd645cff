#pragma once

#include <epoxy/gl.h>

#include <filesystem>
#include <glm/glm.hpp>
#include <initializer_list>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace kerf::gl {

// Where a program's source lies: the files of one stage are compiled as one text in the order given, behind
// the line "#version 330 core".
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

  // Reads and links. On failure one error that names the file and the line as the driver tells them.
  static Result<Program> load(const std::filesystem::path& folder, const ProgramFiles& files);

  void use() const { glUseProgram(name_); }
  GLuint name() const { return name_; }

  // Of the program in use. A name that the compiler dropped is ignored.
  void set(const char* uniform, const glm::mat4& m) const;
  void set(const char* uniform, const glm::mat3& m) const;
  void set(const char* uniform, const glm::vec4& v) const;
  void set(const char* uniform, float x) const;
  void set(const char* uniform, int x) const;
  void bind_block(const char* block, GLuint binding) const;

 private:
  explicit Program(GLuint name) : name_(name) {}
  GLuint name_ = 0;
};

}  // namespace kerf::gl
