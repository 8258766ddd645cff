#pragma once

#include <map>

#include "core/world/world.h"
#include "ui/gl/stream.h"
#include "ui/render/bodies/shaders.h"
#include "ui/render/view/box_choice.h"
#include "ui/render/view/frame_space.h"
#include "ui/render/view/view_options.h"

namespace kerf {

// Draws boxes of the tree and normals of faces as thin coloured lines with a dark outline. The lines of a
// body are collected again when it has changed and is shown, in time linear in its size.
class LineOverlay {
 public:
  explicit LineOverlay(Shaders& shaders);

  // Discards all collected lines.
  void forget() { gathered_.clear(); }
  // Discards the collected lines of one body.
  void forget(BodyId id) { gathered_.erase(id); }
  void draw(BodyId id, const Body& body, const FloatFrame& frame, const FrameSpace& space,
            const glm::mat4& clip_from_frame, const ViewOptions& options);

 private:
  struct Stick {
    glm::vec3 from, to;
  };
  // The lines of one body.
  struct Gathered {
    std::vector<BoxLine> all_boxes;
    gl::Stream<BoxLine> boxes{
        gl::ItemsAre::kInstances,
        {{3, offsetof(BoxLine, low)}, {3, offsetof(BoxLine, high)}, {2, offsetof(BoxLine, style)}}};
    gl::Stream<Stick> sticks{gl::ItemsAre::kInstances,
                             {{3, offsetof(Stick, from)}, {3, offsetof(Stick, to)}}};
    ShowOptions shown;
    TreeOverlay tree;
  };
  void gather(Gathered& lines, const Body& body, const FloatFrame& frame, const ViewOptions& options) const;
  std::vector<BoxLine> gather_boxes(const Body& body, const FloatFrame& frame, const TreeOverlay& tree) const;
  std::vector<Stick> gather_normals(const Body& body, const FloatFrame& frame) const;

  gl::Program box_, stick_;
  std::map<BodyId, Gathered> gathered_;
};

}  // namespace kerf
