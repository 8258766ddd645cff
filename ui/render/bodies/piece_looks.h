#pragma once

#include <glm/vec4.hpp>
#include <map>
#include <memory>
#include <set>
#include <span>
#include <vector>

#include "core/joints/piece_groups.h"
#include "ui/gl/buffers.h"
#include "ui/gl/program.h"
#include "ui/render/view/frame_space.h"
#include "ui/render/view/view_options.h"

namespace kerf {

// The looks of the groups of one body's faces: a loose part has the look of its own piece, but moves with
// the piece it is grouped with.
class BodyLooks {
 public:
  BodyLooks(BodyId id, const ViewOptions& options);

  // The groups with a look other than the default.
  const std::map<uint32_t, PieceLook>& by_group() const { return by_group_; }
  const PieceLook& of(uint32_t group) const;
  const PieceLook& of(const Mesh& mesh, FaceId f) const {
    return of(groups_ ? groups_->of(mesh, f) : mesh.data(f).piece);
  }
  // The groups that a stage of a cut separated (true) from others, and those others (false).
  const std::map<uint32_t, bool>& came_off() const { return came_off_; }

  // Null if the group of each face is the label of its piece.
  const std::shared_ptr<const PieceGroups>& groups() const { return groups_; }

 private:
  void record_separation(BodyId id, const ViewOptions& options);

  std::map<uint32_t, PieceLook> by_group_;
  std::map<uint32_t, bool> came_off_;
  std::shared_ptr<const PieceGroups> groups_;
};

// The groups of the faces as ShadowCaster takes them.
std::span<const uint32_t> labels_of(const std::shared_ptr<const PieceGroups>& groups);

// The looks of one body's groups of faces on the GPU, for programs that contain placed.glsl.
class PieceLooks {
 public:
  // Applies the looks of the body. A part that no cut separated keeps its paint (see is_loaded_part).
  // Returns true if anything changed. O(pieces).
  bool update(const Body& body, const BodyLooks& looks, const FrameSpace& space);

  // Binds the looks for `program`. Precondition: it is in use.
  void bind(const gl::Program& program) const;

  // Returns true if any piece is hidden, displaced or turned; or if any is selected.
  bool any_away() const { return any_away_; }
  bool any_selected() const { return any_selected_; }

 private:
  static void add_row(std::vector<glm::vec4>& table, size_t row);

  std::map<uint32_t, PieceLook> looks_;  // by group
  std::map<uint32_t, bool> came_off_;    // by group
  std::set<uint32_t> parts_;             // groups with the look of the body itself
  UpAxis up_ = UpAxis::kY;               // of the displacements on the GPU
  gl::Buffer buffer_;
  gl::Texture table_;
  int count_ = 0;
  bool any_away_ = false, any_turned_ = false, any_selected_ = false;
};

}  // namespace kerf
