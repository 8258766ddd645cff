#pragma once

#include "ui/editor/tools/hand.h"
#include "ui/editor/view/view_state.h"
#include "ui/editor/work/requests.h"

namespace kerf {

// The chosen piece is moved or turned: what begins, follows, confirms and cancels it, on the picture alone
// until it is confirmed. Places of the pointer are Hand::pointer.

// The sentence why no piece can be moved, or null: exactly one has to be chosen.
const char* why_no_move(const PieceMap& looks);

// Begins with the chosen piece. Precondition: why_no_move() gives no reason. Pieces that are drawn apart
// stand together before.
void begin_move(Hand& hand, ViewState& view, const World& world, PieceMove::Kind kind);
// Shows the piece where the pointer and the keys have it so far.
void follow_move(Hand& hand, ViewState& view);
// Ends it, and shows the piece where it stands in the world. Returns whether there was a move. A copy that
// was moved is taken back by undo.
bool cancel_move(Hand& hand, ViewState& view, Requests& requests);
// Ends it, and asks for the command that moves the piece. Precondition: there is a move.
void confirm_move(Hand& hand, ViewState& view, Requests& requests);
// Ends a move whose piece is gone, without asking for anything.
void drop_lost_move(Hand& hand, ViewState& view, const World& world);

// What a key (GLFW_KEY_*) does during a move: Enter confirms, Esc cancels, G and R change what is done, the
// others go to PieceMove::key.
void move_key(Hand& hand, ViewState& view, const World& world, Requests& requests, int key);

// Chooses the copy that was made since `hand` began to wait for it, if it is there, and begins to move it.
void grab_copy(Hand& hand, ViewState& view, const World& world);

}  // namespace kerf
