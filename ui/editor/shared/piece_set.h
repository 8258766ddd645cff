#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/world/world.h"
#include "core/world/world_delta.h"
#include "ui/render/view/view_options.h"

namespace kerf {

using PieceMap = std::map<PieceId, PieceLook>;

// A piece in the list of pieces.
struct PieceRow {
  PieceId id;
  uint32_t number = 0;  // see PieceLook::number; 0 for a body itself, and for a part
  std::string name;
  size_t faces = 0;
  double area = 0;  // m^2
  bool pinned = false;
  bool part = false;  // no cut separated it (see is_loaded_part)
};

// The pieces that have faces: first the bodies themselves (label 0), then separated pieces, then parts that
// no cut separated, each in descending order of area. Parts have the names that the mesh file gives them.
std::vector<PieceRow> list_pieces(const World& world, const PieceMap& looks = {});

// Splits a list of pieces into specks (see core/document/cut_effects.h) and all else, in the same order.
// One speck alone is left in the rest.
struct SortedPieces {
  std::vector<PieceRow> rest, specks;
};
SortedPieces set_specks_apart(std::vector<PieceRow> rows, const std::set<PieceId>& specks);

// The colour in which ShowOptions::pieces shows a separated piece of this number (sRGB, 0 .. 1); grey for a
// body itself (0).
Vec3 strong_piece_colour(uint32_t number);

// Removes looks in which nothing is set.
void drop_plain(PieceMap& looks);

// Selects a piece instead of all others; if it was the only selected piece, deselects it. With `add` it
// toggles the selection of this piece and keeps that of the others.
void choose_piece(PieceMap& looks, const PieceId& id, bool add);
void choose_none(PieceMap& looks);
size_t chosen_pieces(const PieceMap& looks);
// The sentence that no piece is selected, or null if there are selected pieces.
const char* why_none_chosen(const PieceMap& looks);
// The first selected piece, or nothing.
std::optional<PieceId> first_chosen(const PieceMap& looks);
std::vector<PieceId> hidden_pieces(const PieceMap& looks);
// The pieces that are neither hidden nor selected.
std::vector<PieceId> other_pieces(const World& world, const PieceMap& looks);

// The piece as it is named after a step in which pieces were detached, or put back.
PieceId named_after(const Delta& delta, PieceId id);

// Updates the looks after a step that changed the world by `delta`: pieces of hidden bodies are hidden and
// deselected, all others shown, and pieces without faces are dropped. The look of a piece that was detached,
// or put back, moves to the body that it belongs to since.
void follow_world(const World& world, const Delta& delta, PieceMap& looks);

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
