#pragma once

#include "ui/gl/program.h"
#include "ui/render/subject.h"

namespace kerf {

// Draws every face of every body with depth as a mark of its own into the bound framebuffer, which is
// cleared; nothing is drawn where no face is. Backs are left out where the options cull them. `faces` is the
// program of faces.vert and mark.frag; it is in use afterwards.
void draw_marked_faces(const Subject& subject, const gl::Program& faces);

}  // namespace kerf
