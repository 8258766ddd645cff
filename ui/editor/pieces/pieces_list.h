#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/world/world.h"
#include "ui/editor/shared/piece_set.h"
#include "ui/editor/shared/workspace.h"
#include "ui/render/view/view_options.h"

namespace kerf {

// Isolates pieces: hides all pieces except the selected ones, and later shows only those that it hid, until
// all of them were shown and some are hidden by other means.
class Isolation {
 public:
  // The workspace must outlive it.
  explicit Isolation(Workspace& workspace) : workspace_(workspace) {}

  // Requests the change. Precondition: disabled_reason() is null.
  void change();
  // Returns why nothing can be isolated or shown again, as a sentence, or null.
  const char* disabled_reason() const;

  // Call follow() after each change of the world, and forget() when another document is opened.
  void follow();
  void forget() { isolated_from_.clear(); }

 private:
  std::vector<PieceId> to_show_again() const;

  Workspace& workspace_;
  std::vector<BodyId> isolated_from_;                 // bodies hidden by isolation
  bool is_over_ = false;                              // all of them were shown again
  std::optional<std::vector<BodyId>> hidden_before_;  // while an isolation is in progress
};

// Small switches in the rows of a list, drawn as an eye (open: visible) and a pin, as high as the text.
// Return true if clicked.

// An open eye: the item is visible.
bool eye_switch(bool open, const char* meaning);
bool pin_switch(bool pinned, const char* meaning);

// Returns the width of both switches next to each other.
float width_of_switches();

// Table of the pieces. A click selects a piece; a double click edits its name in place: Enter renames it,
// Esc cancels. Its eye hides or shows it, its pin fixes or releases it. Specks share one row, which a click
// unfolds; its eye is open while one of them is visible, and hides or shows all.
class PiecesList {
 public:
  void draw(Workspace& workspace, const std::vector<PieceRow>& rows);
  // Makes the next draw() edit the name of this piece.
  void rename(const PieceId& piece) {
    asked_ = piece;
    unseen_frames_ = 0;
  }
  // Discards the edit because another document was opened.
  void forget_rename();
  // Returns true if an edit is requested or begun, but its field does not have the focus yet.
  bool awaits_focus() const { return asked_ || (renamed_ && take_focus_); }
  // Call once per frame after drawing all panels: ends an edit whose field was not drawn.
  void end_hidden_edit(Workspace& workspace);

 private:
  void draw_rows(Workspace& workspace, const SortedPieces& sorted);
  void draw_row(Workspace& workspace, const PieceRow& row, bool is_folded);
  void draw_specks(Workspace& workspace, const std::vector<PieceRow>& specks);
  void draw_name(ViewState& view, const PieceRow& row, const PieceLook& look);
  void draw_switches(WorldChanges& changes, const PieceRow& row, bool hidden);
  void begin_rename(const PieceRow& row);
  void begin_asked_rename(const SortedPieces& sorted);
  void edit_name(WorldChanges& changes);
  void take_new_name(WorldChanges& changes);

  std::optional<PieceId> asked_;
  bool specks_unfolded_ = false;
  std::optional<PieceId> renamed_;    // piece whose name is edited
  std::string old_name_;              // of that piece, as the field shows it first
  bool take_focus_ = false;           // the field is new
  bool field_drawn_ = false;          // in this frame
  int unseen_frames_ = 0;             // for which the field stayed out of view
  std::array<char, 128> new_name_{};  // as edited so far
};

// The area of pieces, and the volume that they enclose.
struct PieceMeasures {
  size_t pieces = 0;
  double area = 0;               // m^2, in world units, of one side of each face
  std::optional<double> volume;  // m^3; nullopt if a piece is not closed
};
// Measures pieces that exist. O(faces of their bodies).
PieceMeasures measure_pieces(const World& world, const std::vector<PieceId>& pieces);

// The measures of the selected pieces, computed when the selection or the world has changed, but for a stroke
// only once it is cut.
class SelectionMeasures {
 public:
  void on_world_changed() { measured_.reset(); }
  // Precondition: the looks are those of pieces that exist.
  const PieceMeasures& follow(const Document& document, const PieceMap& looks);

 private:
  // The surface of a piece: unchanged while the number of its faces and their area are.
  struct Surface {
    size_t faces = 0;
    double area = 0;  // m^2
    friend bool operator==(const Surface&, const Surface&) = default;
  };

  std::vector<PieceId> pieces_;
  std::vector<Surface> surfaces_;
  std::optional<PieceMeasures> measured_;  // of these pieces
};

// Draws a line with the measures of the selected pieces.
void draw_measures(const PieceMeasures& measures, FileUnit unit);

}  // namespace kerf
