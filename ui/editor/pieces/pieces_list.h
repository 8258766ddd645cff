#pragma once

#include <array>
#include <optional>

#include "ui/editor/shared/piece_set.h"
#include "ui/editor/shared/workspace.h"

namespace kerf {

// Small switches of a row of a list, drawn as an eye and as a pin, each a square as high as the text. They
// return whether they were clicked.

// Open: what the row stands for is drawn.
bool eye_switch(bool open, const char* meaning);
bool pin_switch(bool pinned, const char* meaning);

// The width of both beside each other.
float width_of_switches();

// The table of the pieces. A click chooses a piece; a double click edits its name in place: Enter renames it,
// Esc leaves the name as it is. A click on its eye hides a piece or shows it again, one on its pin pins it.
// Specks share one row, which a click unfolds.
class PiecesList {
 public:
  using HideChosen = std::function<void()>;

  void draw(Workspace& workspace, const std::vector<PieceRow>& rows, const HideChosen& hide_chosen);
  // The next draw() begins to edit the name of this piece.
  void rename(const PieceId& piece) {
    asked_ = piece;
    unseen_frames_ = 0;
  }
  // Another document is open.
  void forget_rename();
  // Whether a name is about to be edited, and its field does not have the keyboard yet.
  bool awaits_focus() const { return asked_ || (renamed_ && take_focus_); }
  // To be called once a frame when all panels are drawn: ends the edit of a name whose field was not drawn.
  void end_hidden_edit(Workspace& workspace);

 private:
  void draw_rows(Workspace& workspace, const SortedPieces& sorted, const HideChosen& hide_chosen);
  void draw_row(Workspace& workspace, const PieceRow& row, bool is_folded);
  void draw_specks(ViewState& view, const std::vector<PieceRow>& specks, const HideChosen& hide_chosen);
  void draw_name(ViewState& view, const PieceRow& row, const PieceLook& look);
  void draw_switches(WorldChanges& changes, const PieceRow& row, bool hidden);
  void begin_rename(const PieceRow& row);
  void begin_asked_rename(const SortedPieces& sorted);
  void edit_name(WorldChanges& changes);
  void take_new_name(WorldChanges& changes);

  std::optional<PieceId> asked_;
  bool specks_unfolded_ = false;
  std::optional<PieceId> renamed_;    // whose name is being edited
  std::string old_name_;              // of the piece
  bool take_focus_ = false;           // the field of the name is new
  bool field_drawn_ = false;          // in this frame
  int unseen_frames_ = 0;             // in which the field was to come into view and did not
  std::array<char, 128> new_name_{};  // as edited so far
};

}  // namespace kerf
