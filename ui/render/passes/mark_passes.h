#pragma once

#include <span>
#include <vector>

#include "core/graph/drawn_graph.h"
#include "ui/gl/buffers.h"
#include "ui/render/bodies/body_picture.h"
#include "ui/render/bodies/overlay_marks.h"

namespace kerf {

// Draws lines of any colour, each with a dark outline, so that they are visible on any background.
class ColouredLines {
 public:
  explicit ColouredLines(Shaders& shaders);

  struct Line {
    glm::vec3 from, to;  // in the coordinates of FrameSpace
    glm::vec4 colour;
  };
  // Clipping of a line by the section plane: all or nothing, by its middle, or partially.
  enum class AtSection { kWhole, kPart };
  // `half_width` is in pixels of a frame of usual height; see line.glsl. Precondition: blending is enabled.
  void draw(std::span<const Line> lines, float half_width, AtSection section = AtSection::kWhole);

 private:
  gl::Program program_;
  gl::Stream<Line> lines_{gl::ItemsAre::kInstances,
                          {{3, offsetof(Line, from)}, {3, offsetof(Line, to)}, {4, offsetof(Line, colour)}}};
};

// Draws the marks of ViewOptions::bodies over everything: contacts as their normals, redder for larger
// impulses; colliders as chords and small crosses at their points; centres of mass as crosses, coloured by
// awake, asleep or pinned; joints as their axes, hubs with a circle around it, and welds as crosses.
class BodyPass {
 public:
  explicit BodyPass(Shaders& shaders);

  // Draws over the bound framebuffer. Precondition: the uniform block of the frame is bound.
  void draw(const Subject& subject, double diagonal);

 private:
  ColouredLines lines_;
};

// The colour of a kind of marks as 0xrrggbb (sRGB).
uint32_t colour_of(StageMarks::Kind kind);

// Draws the effect of a stage of a cut: translucent faces and volumes, and lines around faces and boxes.
// Surfaces occlude the marks, except for the last visited box, and the section plane clips them.
class StagePass {
 public:
  explicit StagePass(Shaders& shaders);

  // Draws ViewOptions::stage over the bound framebuffer, with depth test. O(marks).
  void draw(const Subject& subject);

 private:
  struct Corner {
    glm::vec3 at;
    glm::vec4 colour;
  };
  void draw_fills(const std::vector<Corner>& corners);

  gl::Program fills_;
  ColouredLines lines_;
  gl::Stream<Corner> corners_{gl::ItemsAre::kVertices,
                              {{3, offsetof(Corner, at)}, {4, offsetof(Corner, colour)}}};
};

// The colour of a node of the component graph as 0xrrggbb (sRGB).
uint32_t colour_of(DrawnGraph::State state);

// Draws a component graph on its faces, occluded by surfaces: a disc on the middle of each face, a line
// over each shared edge, and a line along each loop of removed faces. Also outlines the highlighted face.
class GraphPass {
 public:
  explicit GraphPass(Shaders& shaders);

  // Draws the overlays that the subject's options enable over the bound framebuffer, with depth test.
  // O(nodes).
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
