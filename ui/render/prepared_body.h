#pragma once

#include <map>
#include <memory>

#include "core/shadow/shadow_caster.h"
#include "core/world/world.h"
#include "ui/render/base_faces.h"

namespace kerf {

// What pictures of a body need besides the body and takes long to find out: no OpenGL, so that it can be made
// ahead on another thread.
struct PreparedBody {
  FloatFrame frame;
  BaseFaces bases;
  std::unique_ptr<ShadowCaster> caster;
};
using PreparedBodies = std::map<BodyId, PreparedBody>;

// The frame in which the faces of a body are drawn.
inline FloatFrame picture_frame(const Body& body) {
  return FloatFrame::around(body.tree.bounds().min, body.tree.bounds().max);
}

// Of every body of a world as loaded, none of it cut, or that it was stopped. `progress` may be null.
// Expected linear time.
Result<PreparedBodies> prepare_bodies(const World& world, const Progress* progress);

}  // namespace kerf
