#pragma once

#include "core/document/files/material_reader.h"
#include "ui/editor/shared/view_state.h"
#include "ui/window/number_fields.h"

namespace kerf {

// The piece whose sheet the panel shows: the first chosen one, else the first body. Nothing in an empty
// world.
std::optional<PieceId> piece_of_sheet(const World& world, const ViewState& view);

// The sheet of the chosen pieces, or of all pieces if none is chosen: its material, from
// assets/materials.json, its thickness, and the constants of the material, each of which can be typed. Every
// change is one step of the history.
class MaterialPanel {
 public:
  // Returns the sheet that the user has chosen or typed, if any.
  std::optional<Sheet> draw(const World& world, const ViewState& view);

 private:
  bool draw_presets(Sheet& sheet);
  bool draw_numbers(Sheet& sheet);
  bool draw_constants(Substance& substance);
  template <typename Owner>
  bool number(const NumberField<Owner>& field, const RealFormat& format, Owner& owner);

  NumberFields fields_;
  std::optional<Result<std::vector<Material>>> materials_;  // once the panel was drawn
};

}  // namespace kerf
