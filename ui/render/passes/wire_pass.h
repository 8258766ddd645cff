#pragma once

#include <memory>
#include <vector>

#include "ui/gl/stream.h"
#include "ui/render/bodies/shaders.h"
#include "ui/render/bodies/subject.h"
#include "ui/render/view/drawn_wire.h"

namespace kerf {

// Draws ViewOptions::wire over the surfaces that are there. What lies deeper below a surface than
// DrawnWire::depth is not seen.
class WirePass {
 public:
  explicit WirePass(Shaders& shaders);

  // Draws over the bound picture, whose depth buffer is used. The edges are sent once for each wire.
  void draw(const Subject& subject, const FrameUniforms& frame);

 private:
  using Edges = gl::Stream<DrawnWire::Edge>;

  void send(std::shared_ptr<const DrawnWire> wire);

  gl::Program program_;
  std::shared_ptr<const DrawnWire> sent_;
  std::vector<Edges> edges_;  // by part of the wire that was sent
};

}  // namespace kerf
