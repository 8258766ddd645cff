#pragma once

#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/base/assert.h"
#include "core/base/task.h"
#include "core/cut/stroke_region.h"
#include "core/walls/make_walls.h"

namespace kerf {

struct RimState;

// The walls created, and one sentence with the reason and place for each part left open.
struct ClosedRim {
  std::vector<FaceId> walls;
  std::vector<std::string> left_open;
};

// Closes a solid body along the rim of a stroke by walls, and makes the search for separated pieces cross
// them. Each solid (an outer shell with its cavities) is closed completely or not at all. The work is divided
// into parts.
class WallClosing {
 public:
  // `moves`: all moves of the stroke, in the frame of the body.
  explicit WallClosing(std::vector<BeamMove> moves) : moves_(std::move(moves)) {}
  WallClosing(const WallClosing&) = delete;
  WallClosing& operator=(const WallClosing&) = delete;

  // Executes the next part. Returns true if it was the last one. Preconditions: the body, the region and the
  // state of the rim have not changed since the last part, and the tree is up to date.
  bool resume(RimState& rim);

  // Returns true while only some of the walls exist. All remaining parts must then be executed before any
  // other edit.
  bool is_adding() const { return is_adding_; }

  // Returns the result. Precondition: resume() returned true.
  ClosedRim take() {
    KERF_ASSERT(closing_.has_value());
    return closing_->take();
  }

 private:
  // Sides, as face and start vertex, on edges of several sheets whose rings were already visited.
  using SidesOfRings = std::set<std::pair<FaceId, VertexId>>;

  Task<ClosedRim> close();
  Task<Done> find_open_faces();
  Task<Done> find_sides();
  bool is_unmatched(const Mesh::Side& side, SidesOfRings& seen) const;
  Task<std::vector<bool>> parts_around(const std::vector<FaceId>& faces);
  Task<std::vector<uint32_t>> parts_with_sides();
  void append_connected(FaceId f, SidesOfRings& seen, std::vector<FaceId>& out);
  Task<bool> remove_ears();
  bool is_at_rim(const Mesh::Side& side);
  bool is_ear(std::span<const RimSide> of_face) const;
  void remove(std::vector<FaceId> faces);
  std::vector<std::pair<FaceId, int>> crossings(const Vec3& p, const Vec3& direction) const;
  bool joins_pieces(const WallPatch& patch) const;
  Task<std::vector<FaceId>> add(const WallPatch& patch);
  const Mesh& mesh() const;

  std::vector<BeamMove> moves_;
  RimState* rim_ = nullptr;  // of the current part
  std::optional<SweptDistance> distance_;
  std::vector<FaceId> open_faces_;  // with sides that have no other face on their sheet; ascending
  std::vector<RimSide> sides_;      // along the rim, of parts that were closed before the stroke; by face
  std::vector<std::string> left_open_;
  bool is_adding_ = false;
  std::optional<Task<ClosedRim>> closing_;
};

}  // namespace kerf
