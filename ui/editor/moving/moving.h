#pragma once

#include <optional>

#include "core/document/commands/command.h"
#include "ui/editor/moving/piece_move.h"
#include "ui/editor/shared/picture/view_state.h"

namespace kerf {

// The sentence why no piece can be moved, or null: exactly one has to be chosen.
const char* why_no_move(const PieceMap& looks);

// The chosen piece while it is moved or turned, on the picture alone until that is confirmed. Places of the
// pointer are of the window (screen coordinates).
class Moving {
 public:
  // The view must outlive it.
  explicit Moving(ViewState& view) : view_(view) {}

  bool moves() const { return move_.has_value(); }
  const std::optional<PieceMove>& now() const { return move_; }
  // Precondition of all but begin() and forget(): moves().
  const PieceMove& move() const;

  // Begins with the chosen piece. Precondition: why_no_move() gives no reason. Pieces that are drawn apart
  // stand together before.
  void begin(const World& world, PieceMove::Kind kind, Vec2 pointer);
  // Takes a key (see PieceMove::key).
  bool key(int key);
  void constrain(PieceMove::Axis axis);
  // Shows the piece where the pointer and the keys have it so far. With `snaps`, what follows the pointer
  // goes to a vertex near it or by whole steps (see MoveSnap).
  void follow(const World& world, Vec2 pointer, bool snaps);
  // Ends it, and shows the piece where it stands in the world.
  void end();
  // The same, and returns the command that moves the piece; nothing where it goes nowhere.
  std::optional<Command> confirm();
  // Ends a move whose piece is gone.
  void drop_if_lost(const World& world);
  // Another document is open.
  void forget() { move_.reset(); }

 private:
  ViewState& view_;
  std::optional<PieceMove> move_;
};

}  // namespace kerf
