#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "core/base/ids.h"
#include "core/document/document.h"
#include "core/kerf_c.h"
#include "core/world/world.h"
#include "core/world/world_delta.h"

namespace kerf {

// The changes of a world since a client last took them: the cursor of kerf_world_take_changes. Records
// nothing before the first take.
class ChangeLog {
 public:
  // Records the changes of a step. O(listed faces).
  void record(const World& world, const Delta& delta);
  // Makes the next take() report that everything changed.
  void lose() { everything_ = true; }
  // Records that the history returned to a position: the steps from there on are not those of the last take.
  void on_undo(size_t position) { position_ = std::min(position_, position); }

  // Returns the changes since the last take; they refer to memory of this object, valid until the next take.
  // O(c log c) for c changed faces, plus the pieces of the changed bodies.
  kerf_changes take(const Document& document);

 private:
  struct Touched {
    std::vector<FaceId> corners, labels;  // possibly repeated; faces whose corners or label changed
  };
  // The arrays of a kerf_body_changes.
  struct Answer {
    kerf_body_changes changes{};
    std::vector<uint32_t> added, added_pieces, removed, moved, moved_pieces, destroyed_pieces;
    std::vector<kerf_new_piece> new_pieces;
    void link();
  };

  void follow_bodies(const Delta& delta);
  void forget();
  void find_pieces(const Document& document, BodyId id, Answer& answer);
  static Answer answer_for(const World& world, BodyId id, uint32_t flags, Touched touched);

  bool everything_ = true;
  bool tracks_ = false;  // true from the first take on
  size_t entries_ = 0;   // in touched_
  std::map<BodyId, Touched> touched_;
  Delta bodies_;                                  // without faces
  std::map<BodyId, std::vector<uint32_t>> live_;  // labels of pieces with faces at the last take, ascending
  // Position of the history up to which all steps were complete at the last take and have not been undone.
  size_t position_ = 0;
  std::vector<Answer> answers_;
  std::vector<kerf_body_changes> views_;
  std::vector<kerf_detached> detached_;
};

}  // namespace kerf
