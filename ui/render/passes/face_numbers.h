#pragma once

#include <array>
#include <functional>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "core/base/ids.h"
#include "ui/gl/buffers.h"
#include "ui/gl/framebuffer.h"
#include "ui/render/bodies/body_picture.h"

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

}  // namespace kerf
