#pragma once

#include <glm/vec4.hpp>
#include <map>
#include <set>
#include <vector>

#include "ui/gl/objects.h"
#include "ui/gl/program.h"
#include "ui/render/bodies/body_looks.h"
#include "ui/render/view/frame_space.h"

namespace kerf {

// The looks of one body's groups of faces on the GPU for programs that contain placed.glsl.
class PieceLooks {
 public:
  // Takes over the looks of the body. A part that no cut separated keeps its paint (see is_loaded_part).
  // Returns whether anything changed. O(pieces).
  bool update(const Body& body, const BodyLooks& looks, const FrameSpace& space);

  // Binds the looks for `program`. Precondition: it is in use.
  void bind(const gl::Program& program) const;

  // Whether any piece is hidden, displaced or turned; whether any is selected.
  bool any_away() const { return any_away_; }
  bool any_selected() const { return any_selected_; }

 private:
  static void add_row(std::vector<glm::vec4>& table, size_t row);

  std::map<uint32_t, PieceLook> looks_;  // by group
  std::map<uint32_t, bool> came_off_;    // by group
  std::set<uint32_t> parts_;             // groups that are shown as the body itself is
  UpAxis up_ = UpAxis::kY;               // of the displacements on the GPU
  gl::Buffer buffer_;
  gl::Texture table_;
  int count_ = 0;
  bool any_away_ = false, any_turned_ = false, any_selected_ = false;
};

}  // namespace kerf
