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

struct PieceRow {
  PieceId id;
  uint32_t number = 0;  // see PieceLook::number; 0 for a body and for a part
  std::string name;
  size_t faces = 0;
  double area = 0;  // m^2
  bool pinned = false;
  bool part = false;  // not separated by a cut (see is_loaded_part)
};

// Returns the displayed name of a piece: its given name, that of its part in the mesh file, or that of its
// body with its number. Precondition: its body exists. O(faces of the body) for a part.
std::string name_of_piece(const World& world, const PieceMap& looks, const PieceId& id);

// Lists the pieces that have faces: bodies (label 0), then separated pieces, then parts that no cut
// separated, each in descending order of area. Parts have their names from the mesh file.
std::vector<PieceRow> list_pieces(const World& world, const PieceMap& looks = {});

// The columns by which a list of pieces is sorted. By number, bodies precede pieces, and parts follow.
enum class PieceColumn { kNumber, kFaces, kArea };
void sort_pieces(std::vector<PieceRow>& rows, PieceColumn column, bool is_descending);

// Splits a list of pieces into specks (see core/document/cut_effects.h) and the rest, keeping the order. A
// single speck stays in the rest.
struct SortedPieces {
  std::vector<PieceRow> rest, specks;
};
SortedPieces separate_specks(std::vector<PieceRow> rows, const std::set<PieceId>& specks);

// Returns the colour of a piece of this number under ShowOptions::pieces (sRGB, 0 .. 1); grey for a body
// (0).
Vec3 strong_piece_colour(uint32_t number);

// Removes looks in which nothing is set.
void drop_plain(PieceMap& looks);

// Selects only this piece, or deselects it if it was the only selected one. `add`: toggles this piece and
// keeps the rest of the selection. No-op for a hidden piece.
void select_piece(PieceMap& looks, const PieceId& id, bool add);
void deselect_all(PieceMap& looks);
size_t selected_count(const PieceMap& looks);
// Returns an error sentence if no piece is selected, otherwise null.
const char* no_selection_reason(const PieceMap& looks);
std::optional<PieceId> first_selected(const PieceMap& looks);
// Returns the bounds of the selected pieces in world space, at the places where they are drawn;
// Bounds::none() if they have no faces. O(faces).
Bounds selected_bounds(const World& world, const ViewOptions& options);
// Returns the bounds of all pieces at the places where they are drawn; those of the world unless a piece is
// displaced. O(bodies + pieces), or O(faces) if one is.
Bounds drawn_bounds(const World& world, const ViewOptions& options);
std::vector<PieceId> hidden_pieces(const PieceMap& looks);
// Returns the pieces that are neither hidden nor selected.
std::vector<PieceId> other_pieces(const World& world, const PieceMap& looks);

// Returns the id of a piece after a step that detached or reattached pieces.
PieceId named_after(const Delta& delta, PieceId id);

// Updates the ids of pieces after a change of the world, and removes pieces without faces: after an undo, the
// next piece that is cut off gets the label of one of them.
void follow_world(const World& world, const Delta& delta, std::vector<PieceId>& pieces);

// Updates the looks after a change of the world: pieces of hidden bodies are hidden and deselected, all
// others shown, and pieces without faces are dropped. The look of a piece that was detached or reattached
// moves to its new body.
void follow_world(const World& world, const Delta& delta, PieceMap& looks);

// Numbers of the pieces, for their colours and names. A new piece is numbered by its label. A recut may
// change the order of labels, so a piece with the centre and area of an earlier one keeps that number.
class PieceNumbers {
 public:
  // Updates the numbers in `looks` after pieces appeared or disappeared. `replaced`: after undo, redo or a
  // recut, when a label may denote another piece; the selection then moves with its piece. `may_return`:
  // missing pieces may return by redo or a recut in progress; their numbers are kept for them. While a search
  // for separated parts is open, the update is deferred to the next call. O(n log n) in the pieces, plus new
  // pieces times those that may return.
  void follow(const World& world, bool replaced, bool may_return, PieceMap& looks);
  // Returns true if an update is deferred.
  bool waits() const { return waits_; }

 private:
  struct Known {
    PieceId id;
    BodyId loaded_as;
    uint32_t number = 0;
    double area = 0;  // m^2
    Vec3 centre{0};   // m, world space
    bool present = true;
  };

  static std::vector<Known> pieces_of(const World& world);
  void match(std::vector<Known>& created);
  void move_selection(const std::vector<std::optional<PieceId>>& before, PieceMap& looks) const;
  uint32_t free_number(const Known& piece) const;

  std::vector<Known> known_;
  bool replaced_ = false;  // since the last update
  bool waits_ = false;
};

}  // namespace kerf
