#pragma once

#include <filesystem>

#include "core/base/result.h"
#include "ui/gl/program.h"

namespace kerf {

// Loads the programs of passes from assets/shaders into the current context, and binds their blocks "Frame"
// and "Paints". Whoever has created passes with it asks status(): after the first program that cannot be
// loaded, all others are empty, and the passes must not draw.
class Shaders {
 public:
  Shaders();

  // Takes the files as gl::Program::load does.
  gl::Program load(const gl::ProgramFiles& files);
  const Status& status() const { return status_; }

 private:
  std::filesystem::path folder_;
  Status status_ = Done{};
};

}  // namespace kerf
