#pragma once

#include "core/mesh/files/mesh_format.h"
#include "ui/editor/prepare/preparation.h"
#include "ui/editor/shared/viewport.h"
#include "ui/window/number_fields.h"

namespace kerf {

// Draws the switch of the preview and, while it is on, the numbers before and after: faces, smallest angle
// and distance of the surfaces. `disabled_reason`: why there is no preview, or null.
void draw_preview(const LivePreview& preview, const char* disabled_reason, FileUnit unit, bool& previewed);

// Names the affected pieces: "All pieces", "3 selected pieces", or the name of one.
std::string prepared_text(std::span<const PieceRow> pieces, const PieceMap& looks);

// Forecasts the result: "69 666 faces become about 7 000.", or for simplification to an error, "... become
// as few as stay within 0.2 mm."
std::string forecast_text(std::span<const PieceRow> pieces, const Preparation& preparation, FileUnit unit);

// Fills numbers that are not set with defaults: half of the faces, a thousandth of the world size.
Preparation with_numbers(const Preparation& preparation, std::span<const PieceRow> pieces,
                         const World& world);

// Edits a preparation and forecasts its result.
class PreparePanel {
 public:
  // Returns true if the preparation is to be applied now. `previewed`: switch of the preview.
  bool draw(const World& world, const ViewState& view, Preparation& preparation, const LivePreview& preview,
            bool& previewed);

 private:
  void draw_numbers(Preparation& preparation, const Preparation& shown, const World& world, FileUnit unit);
  void draw_times(Preparation& preparation, const char* meaning, size_t most);

  NumberFields fields_;
};

}  // namespace kerf
