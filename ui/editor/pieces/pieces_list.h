#pragma once

#include <array>
#include <optional>

#include "ui/editor/shared/pieces/piece_set.h"
#include "ui/editor/shared/workspace.h"

namespace kerf {

// The table of the pieces. A click chooses a piece; a double click edits its name in place: Enter renames it,
// Esc leaves the name as it is. A click on its eye hides a piece or shows it again, one on its pin pins it.
// Specks share one row, which a click unfolds.
class PiecesList {
 public:
  using HideChosen = std::function<void()>;

  void draw(Workspace& on, const std::vector<PieceRow>& rows, const HideChosen& hide_chosen);
  // The next draw() begins to edit the name of this piece.
  void rename(const PieceId& piece) { asked_ = piece; }

 private:
  void draw_rows(Workspace& on, const SortedPieces& sorted, const HideChosen& hide_chosen);
  void draw_row(Workspace& on, const PieceRow& row, bool is_folded);
  void draw_specks(ViewState& view, const std::vector<PieceRow>& specks, const HideChosen& hide_chosen);
  void draw_name(ViewState& view, const PieceRow& row, const PieceLook& look);
  void draw_switches(WorldChanges& changes, const PieceRow& row, bool hidden);
  void begin_rename(const PieceRow& row);
  void begin_asked_rename(const SortedPieces& sorted);
  void edit_name(WorldChanges& changes, const PieceRow& row);

  std::optional<PieceId> asked_;
  bool specks_unfolded_ = false;
  std::optional<PieceId> renamed_;    // whose name is being edited
  bool take_focus_ = false;           // the field of the name is new
  std::array<char, 128> new_name_{};  // as edited so far
};

}  // namespace kerf
