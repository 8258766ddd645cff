#include "core/document/commands/set_sheet.h"

#include "core/document/commands/edit_piece.h"
#include "core/document/substance_numbers.h"

namespace kerf {

std::string SetSheet::words() const { return "Material of " + piece_words(piece); }

void SetSheet::write(CommandWriter& line) const {
  line.piece(piece);
  line.number("thickness", sheet.thickness);
  line.number("density", sheet.density);
  Substance written = sheet.substance;
  for (const SubstanceNumber& constant : substance_numbers(written))
    line.number(constant.key, constant.number);
}

Result<SetSheet> SetSheet::read(const CommandReader& line) {
  const auto piece = line.piece();
  if (!piece) return piece.error();
  SetSheet command{*piece, {}};
  const auto thickness = line.number_within("thickness", 1e-9, 1e3);
  if (!thickness) return thickness.error();
  const auto density = line.number_within("density", 1e-3, 1e6);
  if (!density) return density.error();
  command.sheet.thickness = *thickness;
  command.sheet.density = *density;
  for (const SubstanceNumber& constant : substance_numbers(command.sheet.substance)) {
    const auto number = line.number_within(constant.key, constant.least, constant.most);
    if (!number) return number.error();
    constant.number = *number;
  }
  return command;
}

Result<Delta> SetSheet::run(World& world, uint32_t generation, const Progress*) const {
  return edit_piece(
      world, piece, generation, [&](const Body& body) { return body.sheet != sheet; },
      [&](World& edited, BodyId own) {
        edited.body(own).sheet = sheet;
        Delta change;
        change.moved = {own};  // its mass is another one
        return change;
      });
}

}  // namespace kerf
