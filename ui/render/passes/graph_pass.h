#pragma once

#include <vector>

#include "core/graph/drawn_graph.h"
#include "ui/gl/stream.h"
#include "ui/render/bodies/shaders.h"
#include "ui/render/bodies/subject.h"
#include "ui/render/passes/coloured_lines.h"

namespace kerf {

// The colour of a node of the component graph as 0xrrggbb (sRGB).
uint32_t colour_of(DrawnGraph::State state);

// Draws a component graph on the faces whose graph it is: a disc on the middle of each face and a line over
// each shared edge, and a line along each loop of removed faces; what a surface hides is not seen. Also the
// outline of the face that is lit.
class GraphPass {
 public:
  explicit GraphPass(Shaders& shaders);

  // Draws over the bound picture, whose depth buffer is used, what the subject's options say. O(nodes).
  void draw(const Subject& subject, const FrameUniforms& frame);

 private:
  struct Disc {
    glm::vec3 middle;
    float radius;
    glm::vec4 colour;
  };
  void draw_graph(const Subject& subject, const DrawnGraph& graph, const FrameUniforms& frame);
  void draw_loops(const Subject& subject, const DrawnGraph& graph);
  void draw_lit_face(const Subject& subject);
  void draw_discs(const std::vector<Disc>& discs);

  ColouredLines links_;
  gl::Program nodes_;
  gl::Stream<Disc> discs_{
      gl::ItemsAre::kInstances,
      {{3, offsetof(Disc, middle)}, {1, offsetof(Disc, radius)}, {4, offsetof(Disc, colour)}}};
};

}  // namespace kerf
