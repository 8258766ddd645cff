#pragma once

#include <array>
#include <functional>
#include <glm/glm.hpp>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/ids.h"
#include "core/world/world.h"
#include "ui/gl/buffers.h"
#include "ui/gl/program.h"
#include "ui/render/bodies/body_picture.h"
#include "ui/render/view/camera.h"
#include "ui/render/view/view_options.h"

namespace kerf {

// A visible face that could be labelled with its number.
struct LabelCandidate {
  FaceId face;
  FaceId base;                         // the loaded face that contains it
  int body = 0;                        // an index defined by the caller
  bool removed = false;                // it was removed
  std::array<glm::vec2, 3> corners{};  // pixels from the lower left of the frame
  float depth = 0;                     // any measure that increases with the distance from the eye

  glm::vec2 middle() const { return (corners[0] + corners[1] + corners[2]) / 3.0f; }
};

struct FaceLabel {
  uint32_t number = 0;
  bool removed = false;
  glm::vec2 at{0};    // its lower left corner, whole pixels
  glm::vec2 size{0};  // pixels
};

// The size of a digit in pixels.
struct DigitShape {
  float width = 6, height = 10;
};

// Selects legible numbers, nearest first: each lies within the frame and within its face, for which `seen`
// must return true if its middle is visible, and overlaps no other number. O(n log n).
std::vector<FaceLabel> place_labels(std::vector<LabelCandidate> candidates, glm::ivec2 picture,
                                    const DigitShape& digit,
                                    const std::function<bool(const LabelCandidate&)>& seen);

// Draws the numbers of faces, including removed ones, over a frame. Renders the faces into an off-screen ID
// buffer and reads it back, so that each number lies on its face.
class FaceNumbers {
 public:
  explicit FaceNumbers(Shaders& shaders);

  // Draws over `picture` and leaves it bound. O(faces).
  void draw(const Subject& subject, const FrameUniforms& frame, const gl::Framebuffer& picture);

  // Draws any numbers over the bound framebuffer, each with its lower left corner at a given pixel.
  void draw_labels(const std::vector<FaceLabel>& labels, int zoom);

 private:
  struct Glyph {
    glm::vec2 place, style;
  };
  void make_bitmaps();
  // Returns the visible faces, four bytes per pixel as written by faces.vert.
  std::vector<uint8_t> look_which(const Subject& subject, int width, int height);

  gl::Program faces_, removed_, numbers_;
  std::optional<gl::Framebuffer> which_;
  gl::Texture bitmaps_;
  gl::Stream<Glyph> glyphs_{gl::ItemsAre::kInstances, {{2, 0}, {2, sizeof(glm::vec2)}}};
};

// Draws the AABB tree's boxes and the normals of faces as thin coloured lines with a dark outline. Normals
// are displaced, turned and hidden with their pieces, boxes are not. Rebuilds the lines of a body when it has
// changed and is shown, in time linear in its size.
class LineOverlay {
 public:
  explicit LineOverlay(Shaders& shaders);

  void forget() { gathered_.clear(); }
  void forget(BodyId id) { gathered_.erase(id); }
  // Precondition: the looks of `picture` are up to date with the options.
  void draw(BodyId id, const Body& body, const BodyPicture& picture, const FrameSpace& space,
            const glm::mat4& clip_from_frame, const ViewOptions& options);

 private:
  struct Stick {
    glm::vec3 from, to;
    float group;  // packed_piece of that of its face
  };
  struct Gathered {
    std::vector<BoxLine> all_boxes;
    gl::Stream<BoxLine> boxes{
        gl::ItemsAre::kInstances,
        {{3, offsetof(BoxLine, low)}, {3, offsetof(BoxLine, high)}, {2, offsetof(BoxLine, style)}}};
    gl::Stream<Stick> sticks{
        gl::ItemsAre::kInstances,
        {{3, offsetof(Stick, from)}, {3, offsetof(Stick, to)}, {1, offsetof(Stick, group)}}};
    gl::Stream<BoxLine> path{
        gl::ItemsAre::kInstances,
        {{3, offsetof(BoxLine, low)}, {3, offsetof(BoxLine, high)}, {2, offsetof(BoxLine, style)}}};
    ShowOptions shown;
    TreeOverlay tree;
    std::shared_ptr<const PieceGroups> groups;
  };
  void gather(Gathered& lines, const Body& body, const FloatFrame& frame, const ViewOptions& options,
              std::shared_ptr<const PieceGroups> groups) const;
  std::vector<BoxLine> gather_boxes(const Body& body, const FloatFrame& frame, const TreeOverlay& tree) const;
  std::vector<Stick> gather_normals(const Body& body, const FloatFrame& frame,
                                    const PieceGroups* groups) const;
  void draw_boxes(Gathered& lines, const glm::mat4& from_body, const ViewOptions& options) const;

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

// Clears the bound framebuffer and draws every face of every body, with depth, as a value that identifies
// it. Back faces are omitted if the options cull them. `faces` is the program of faces.vert and mark.frag;
// it is in use afterwards.
void draw_marked_faces(const Subject& subject, const gl::Program& faces);

// Draws a thin outline around selected pieces, even if other surfaces hide them.
class OutlinePass {
 public:
  explicit OutlinePass(Shaders& shaders);

  // Draws over `picture` and leaves it bound. No cost if no piece is selected.
  void draw(const Subject& subject, const gl::Framebuffer& picture);

 private:
  void draw_selected(const Subject& subject) const;

  gl::Program faces_, outline_;
  gl::NoVertices no_vertices_;
  std::optional<gl::Framebuffer> mask_;
};

// Draws the removed surface as a faint veil or in solid red.
class VeilPass {
 public:
  explicit VeilPass(Shaders& shaders);

  // Draws into the bound framebuffer, with depth test, after all opaque surfaces.
  enum class Style { kVeil, kRed };
  void draw(const Subject& subject, Style style) const;

 private:
  void draw_removed_faces(const Subject& subject) const;

  gl::Program veil_, faces_;
};

// Draws the removed surface with a state, slightly behind the remaining one, so that it is visible only
// where faces are missing. Bodies are numbered from 1 to 127 cyclically. Precondition: `program`, which
// contains veil.vert, is in use.
void draw_removed(const Subject& subject, const gl::Program& program, gl::State state);

}  // namespace kerf
