#pragma once

#include <array>
#include <optional>

#include "core/world/world.h"
#include "ui/editor/view/piece_set.h"
#include "ui/editor/view/view_state.h"
#include "ui/editor/work/requests.h"

namespace kerf {

// The table of the pieces. A click chooses a piece; a double click, or ViewState::renaming, edits its name in
// place: Enter renames it, Esc leaves the name as it is. Crumbs share one row, which a click unfolds.
class PiecesList {
 public:
  void draw(ViewState& view, Requests& requests, const std::vector<PieceRow>& rows);

 private:
  void draw_rows(ViewState& view, Requests& requests, const SortedPieces& sorted);
  void draw_row(ViewState& view, Requests& requests, const PieceRow& row, bool is_crumb);
  void draw_crumbs(ViewState& view, Requests& requests, const std::vector<PieceRow>& crumbs);
  void draw_name(ViewState& view, const PieceRow& row, const PieceLook& look);
  void begin_rename(const PieceRow& row);
  void begin_asked_rename(ViewState& view, const SortedPieces& sorted);
  void edit_name(Requests& requests, const PieceRow& row);

  bool crumbs_unfolded_ = false;
  std::optional<PieceId> renamed_;    // whose name is being edited
  bool take_focus_ = false;           // the field of the name is new
  std::array<char, 128> new_name_{};  // as edited so far
};

}  // namespace kerf
