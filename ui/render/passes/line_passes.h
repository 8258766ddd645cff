#pragma once

#include <map>
#include <memory>
#include <vector>

#include "core/world/world.h"
#include "ui/gl/buffers.h"
#include "ui/render/bodies/body_picture.h"
#include "ui/render/view/frame_space.h"
#include "ui/render/view/view_options.h"

namespace kerf {

// Draws the AABB tree's boxes and the normals of faces as thin coloured lines with a dark outline. Rebuilds
// the lines of a body when it has changed and is shown, in time linear in its size.
class LineOverlay {
 public:
  explicit LineOverlay(Shaders& shaders);

  void forget() { gathered_.clear(); }
  void forget(BodyId id) { gathered_.erase(id); }
  void draw(BodyId id, const Body& body, const FloatFrame& frame, const FrameSpace& space,
            const glm::mat4& clip_from_frame, const ViewOptions& options);

 private:
  struct Stick {
    glm::vec3 from, to;
  };
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

// Draws ViewOptions::wire over the visible surfaces. Edges deeper below a surface than DrawnWire::depth are
// hidden.
class WirePass {
 public:
  explicit WirePass(Shaders& shaders);

  // Draws over the bound framebuffer, with depth test. Uploads the edges once per wire.
  void draw(const Subject& subject, const FrameUniforms& frame);

 private:
  using Edges = gl::Stream<DrawnWire::Edge>;

  void send(std::shared_ptr<const DrawnWire> wire);

  gl::Program program_;
  std::shared_ptr<const DrawnWire> sent_;
  std::vector<Edges> edges_;  // by part of the uploaded wire
};

// Draws the intersection of faces with the section plane as a line.
class SectionPass {
 public:
  explicit SectionPass(Shaders& shaders);

  // Draws over the bound framebuffer, whose depth is that of the bodies. No cost without a section plane.
  // Precondition: the uniform block of the frame is bound.
  void draw(const Subject& subject, int height) const;

 private:
  gl::Program line_;
};

}  // namespace kerf
