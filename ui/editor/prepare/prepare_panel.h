#pragma once

#include "core/mesh/files/mesh_format.h"
#include "ui/editor/prepare/preparation.h"
#include "ui/editor/shared/viewport.h"
#include "ui/window/number_fields.h"

namespace kerf {

// Draws the switch of the preview and, while it is on, the statistics before and after: faces, least angle
// and the distance of the two surfaces. `disabled_reason`: why there is no preview, or null.
void draw_preview(const LivePreview& preview, const char* disabled_reason, FileUnit unit, bool& previewed);

// What the preparation is of: "All pieces", "3 chosen pieces", or the name of one.
std::string prepared_text(std::span<const PieceRow> pieces, const PieceMap& looks);

// What it leads to: "69 666 faces become about 7 000.", or where only the error is given, "... become as few
// as stay within 0.2 mm."
std::string forecast_text(std::span<const PieceRow> pieces, const Preparation& preparation, FileUnit unit);

// The preparation with the numbers that were not chosen yet: half of the faces, a thousandth of the size of
// the world.
Preparation with_numbers(const Preparation& preparation, std::span<const PieceRow> pieces,
                         const World& world);

// Simplifies, subdivides or smooths the chosen pieces, or all of them if none is chosen, after it has told
// what the numbers will be.
class PreparePanel {
 public:
  // Returns whether it is to be done now. `previewed` is the switch of the preview.
  bool draw(const World& world, const ViewState& view, Preparation& preparation, const LivePreview& preview,
            bool& previewed);

 private:
  void draw_numbers(Preparation& preparation, const Preparation& shown, const World& world, FileUnit unit);
  void draw_times(Preparation& preparation, const char* meaning, size_t most);

  NumberFields fields_;
};

}  // namespace kerf
