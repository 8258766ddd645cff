#pragma once

#include <functional>

#include "core/world/world.h"
#include "ui/editor/inspect/placement_rows.h"
#include "ui/editor/panels/pieces_list.h"
#include "ui/editor/view/view_state.h"
#include "ui/editor/work/requests.h"

namespace kerf {

// The pieces, what is done with the chosen ones, where the chosen one stands, and how far they are drawn
// apart.
class PiecesPanel {
 public:
  // `browse_export` lets the user choose a file for the chosen pieces.
  void draw(const World& world, ViewState& view, Requests& requests,
            const std::function<void()>& browse_export);

 private:
  PiecesList list_;
  PlacementRows placement_;
};

}  // namespace kerf
