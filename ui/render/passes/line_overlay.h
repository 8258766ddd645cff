#pragma once

#include <map>

#include "core/world/world.h"
#include "ui/gl/objects.h"
#include "ui/gl/program.h"
#include "ui/render/view/box_choice.h"
#include "ui/render/view/frame_space.h"
#include "ui/render/view/view_options.h"

namespace kerf {

// Draws boxes of the tree and normals of faces as thin coloured lines with a dark outline. The lines of a
// body are collected again when it has changed and is shown, in time linear in its size.
class LineOverlay {
 public:
  static Result<LineOverlay> create(const std::filesystem::path& shaders);

  // Discards all collected lines.
  void forget() { gathered_.clear(); }
  // The same of one body.
  void forget(BodyId id) { gathered_.erase(id); }
  void draw(BodyId id, const Body& body, const FloatFrame& frame, const FrameSpace& space,
            const glm::mat4& clip_from_frame, const ViewOptions& options);

 private:
  LineOverlay(gl::Program box, gl::Program stick);

  // The lines of one body on the GPU, one instance per line.
  struct Lines {
    gl::Buffer buffer;
    gl::VertexArray layout;
    GLsizei count = 0;
  };
  struct Gathered {
    std::vector<BoxLine> all_boxes;
    Lines boxes, sticks;
    ShowOptions shown;
    TreeOverlay tree;
  };
  void gather(Gathered& lines, const Body& body, const FloatFrame& frame, const ViewOptions& options) const;
  std::vector<BoxLine> gather_boxes(const Body& body, const FloatFrame& frame, const TreeOverlay& tree) const;
  void send_boxes(Lines& lines, const std::vector<BoxLine>& boxes) const;
  void gather_normals(Lines& lines, const Body& body, const FloatFrame& frame) const;

  gl::Program box_, stick_;
  std::map<BodyId, Gathered> gathered_;
};

}  // namespace kerf
