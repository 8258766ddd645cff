#include "ui/render/bodies/shaders.h"

#include "core/base/assets.h"
#include "ui/render/bodies/body_picture.h"

namespace kerf {

Shaders::Shaders() : folder_(assets_folder() / "shaders") {}

gl::Program Shaders::load(const gl::ProgramFiles& files) {
  if (!status_) return {};
  Result<gl::Program> program = gl::Program::load(folder_, files);
  if (!program) {
    status_ = program.error();
    return {};
  }
  program->bind_block("Frame", kFrameBlock);
  program->bind_block("Paints", kPaintBlock);
  return std::move(*program);
}

}  // namespace kerf
