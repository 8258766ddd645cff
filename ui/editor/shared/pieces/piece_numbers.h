#pragma once

#include <vector>

#include "core/world/world.h"
#include "ui/editor/shared/pieces/piece_set.h"

namespace kerf {

// The numbers by which pieces are shown: their colours and names. A new piece is shown by its label. Labels
// are given in the order in which parts come off, which may change when a stroke is cut again; a piece that
// takes the place of an earlier one, by its centre and area, therefore keeps the number of that one.
class PieceNumbers {
 public:
  // Updates the numbers in `looks` after pieces came or went. `anew`: by undo, redo or a recut, so that a
  // label may name another piece than before. `may_return`: pieces that are not there may come back, by a
  // recut that is being walked or by redo; their numbers are kept for them. While a search for separated
  // parts is open, the update waits for the next call. O(n log n) in the pieces, plus those that came times
  // those that may return.
  void follow(const World& world, bool anew, bool may_return, PieceMap& looks);
  // Whether an update waits.
  bool waits() const { return waits_; }

 private:
  struct Known {
    PieceId id;
    BodyId loaded_as;
    uint32_t number = 0;
    double area = 0;  // m^2
    Vec3 centre{0};   // m, where the piece stands
    bool present = true;
  };

  static std::vector<Known> pieces_of(const World& world);
  void match(std::vector<Known>& came);
  uint32_t free_number(const Known& piece) const;

  std::vector<Known> known_;
  bool anew_ = false;  // since the last update
  bool waits_ = false;
};

}  // namespace kerf
