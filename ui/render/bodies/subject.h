#pragma once

#include <epoxy/gl.h>

#include "core/world/world.h"
#include "ui/render/bodies/body_picture.h"
#include "ui/render/view/frame_space.h"
#include "ui/render/view/view_options.h"

namespace kerf {

// What a pass draws, and with which options.
struct Subject {
  const World& world;
  std::map<BodyId, BodyPicture>& bodies;
  const FrameSpace& space;
  const ViewOptions& options;

  // The sides of faces that are not drawn.
  GLenum culled() const { return options.cull_backs ? GL_BACK : GL_NONE; }
};

// Calls visit(id, body, picture) for every body of the world that has a picture, in the order of ids.
template <typename Visit>
void for_each_body(const Subject& subject, const Visit& visit) {
  for (auto& [id, picture] : subject.bodies) {
    if (subject.world.contains(id)) visit(id, subject.world.body(id), picture);
  }
}

// Draws the bodies with a program that is in use.
inline void draw_bodies(const Subject& subject, const gl::Program& program) {
  for_each_body(subject, [&](BodyId, const Body& body, const BodyPicture& picture) {
    picture.draw(program, subject.space, body.placement);
  });
}

}  // namespace kerf
