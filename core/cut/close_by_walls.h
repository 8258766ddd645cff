#pragma once

// Private to core/cut.
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "core/base/resumable.h"
#include "core/cut/swept_distance.h"
#include "core/walls/make_walls.h"

namespace kerf {

struct RimState;

// Closes a solid body along the rim that a stroke has left, by walls, and makes the search for parts cross
// them: all of the rim or nothing. The work is done in parts.
class WallClosing {
 public:
  // The moves are those of the stroke in the frame of the body.
  explicit WallClosing(std::vector<BeamMove> moves) : moves_(std::move(moves)) {}
  WallClosing(const WallClosing&) = delete;
  WallClosing& operator=(const WallClosing&) = delete;

  // Does the next part. Returns whether it was the last one. Preconditions: the body, the region and what is
  // known of the rim are as the last part left them, with the tree up to date.
  bool go_on(RimState& rim);

  // Whether some walls are there and others not: the last part has to be done before anything else is.
  bool is_adding() const { return is_adding_; }

  // The walls, or, with the rim still open, a sentence that says why the body stays open. Precondition: the
  // last part was done.
  Result<std::vector<FaceId>> take_walls() { return closing_->take(); }

 private:
  Resumable<Result<std::vector<FaceId>>> close();
  Resumable<Done> find_open_faces();
  Resumable<Status> find_sides();
  Resumable<std::vector<bool>> parts_around(const std::vector<FaceId>& faces);
  Resumable<bool> remove_ears();
  bool is_at_rim(const Mesh::Side& side);
  bool is_ear(std::span<const RimSide> of_face) const;
  void remove(std::vector<FaceId> faces);
  int winding(const Vec3& p, const Vec3& direction) const;
  Resumable<bool> touches_ring(const WallPatch& patch) const;
  bool joins_pieces(const WallPatch& patch) const;
  Resumable<std::vector<FaceId>> add(const WallPatch& patch);
  const Mesh& mesh() const;

  std::vector<BeamMove> moves_;
  RimState* rim_ = nullptr;  // of the part at hand
  std::optional<SweptDistance> distance_;
  std::vector<FaceId> open_faces_;  // that have sides without another face; ascending
  std::vector<RimSide> sides_;      // along the rim, of parts that were closed before the stroke; by face
  bool is_adding_ = false;
  std::optional<Resumable<Result<std::vector<FaceId>>>> closing_;
};

}  // namespace kerf
