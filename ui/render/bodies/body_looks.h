#pragma once

#include <map>
#include <memory>
#include <span>

#include "core/joints/piece_groups.h"
#include "ui/render/view/view_options.h"

namespace kerf {

// How the groups of one body's faces are looked at: a loose part as its own piece is, but moved with the
// piece that it goes with.
class BodyLooks {
 public:
  BodyLooks(BodyId id, const ViewOptions& options);

  // The groups that are not looked at plainly.
  const std::map<uint32_t, PieceLook>& by_group() const { return by_group_; }
  const PieceLook& of(uint32_t group) const;
  // The look of the group of a face (see PieceGroups).
  const PieceLook& of(const Mesh& mesh, FaceId f) const {
    return of(groups_ ? groups_->of(mesh, f) : mesh.data(f).piece);
  }
  // The groups that a stage of a cut separated (true) from others, and those others (false).
  const std::map<uint32_t, bool>& came_off() const { return came_off_; }

  // Null if the group of each face is the label of its piece.
  const std::shared_ptr<const PieceGroups>& groups() const { return groups_; }

 private:
  void note_separation(BodyId id, const ViewOptions& options);

  std::map<uint32_t, PieceLook> by_group_;
  std::map<uint32_t, bool> came_off_;
  std::shared_ptr<const PieceGroups> groups_;
};

// The groups of the faces as ShadowCaster takes them.
std::span<const uint32_t> labels_of(const std::shared_ptr<const PieceGroups>& groups);

}  // namespace kerf
