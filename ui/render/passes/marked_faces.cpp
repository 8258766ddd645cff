#include "ui/render/passes/marked_faces.h"

#include "ui/gl/state.h"
#include "ui/render/view/section_clip.h"

namespace kerf {

void draw_marked_faces(const Subject& subject, const gl::Program& faces) {
  glClearColor(0, 0, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  const gl::ScopedState state({.culled = subject.culled()});
  const SectionClip clip(subject.options);
  faces.use();
  faces.set("only", 0);
  int number = 0;
  for_each_body(subject, [&](BodyId, const Body& body, const BodyPicture& picture) {
    faces.set("body", (number++ % 127) + 1);
    picture.bind(faces, subject.space, body.placement);
    picture.faces().draw_numbered(faces);
  });
}

}  // namespace kerf
