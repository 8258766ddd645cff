#include "ui/editor/material/material_feature.h"

#include "ui/editor/material/laser_heat_rows.h"
#include "ui/editor/material/material_panel.h"
#include "ui/editor/shared/long_step.h"
#include "ui/editor/shared/piece_set.h"

namespace kerf {

namespace {

class MaterialFeature : public Feature {
 public:
  explicit MaterialFeature(Workspace& on) : on_(on) {}

  std::vector<Panel> panels() override {
    return {{"Laser", 110, true, [this] { draw_heat(); }},
            {"Material", 200, false, [this] { draw_material(); }}};
  }

 private:
  void draw_heat() {
    const auto piece = piece_of_sheet(on_.world(), on_.view);
    heat_.draw(on_, piece ? on_.world().body(piece->body).sheet : Sheet());
  }
  void draw_material() {
    const auto sheet = panel_.draw(on_.world(), on_.view);
    if (!sheet) return;
    on_.changes.ask({.name = "Set the material",
                     .run = [this, sheet = *sheet] { return set_sheet(sheet), true; },
                     .is_one = true});
  }
  void set_sheet(const Sheet& sheet);

  Workspace& on_;
  MaterialPanel panel_;
  LaserHeatRows heat_;
};

// Sets the sheet of the chosen pieces, or of all pieces if none is chosen.
void MaterialFeature::set_sheet(const Sheet& sheet) {
  std::vector<PieceId> pieces;
  const PieceMap& looks = on_.view.look.pieces;
  const bool all = chosen_pieces(looks) == 0;
  for (const PieceRow& row : list_pieces(on_.world(), looks)) {
    const auto look = looks.find(row.id);
    const bool chosen = look != looks.end() && look->second.selected;
    if (!row.part && (all || chosen)) pieces.push_back(row.id);
  }
  cancel_stroke(on_);
  on_.changes.change("Set the material", is_small(on_.work.document),
                     edit_all(std::move(pieces), [sheet](const PieceId& p) {
                       return SetSheet{p, sheet};
                     }));
}

}  // namespace

std::unique_ptr<Feature> material_feature(Workspace& on) { return std::make_unique<MaterialFeature>(on); }

}  // namespace kerf
