#pragma once

#include "ui/gl/program.h"
#include "ui/render/bodies/subject.h"

namespace kerf {

// Clears the bound framebuffer and draws every face of every body, with depth, as a value that identifies it.
// Back faces are omitted if the options cull them. `faces` is the program of faces.vert and mark.frag; it is
// in use afterwards.
void draw_marked_faces(const Subject& subject, const gl::Program& faces);

}  // namespace kerf
