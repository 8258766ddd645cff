#include "core/document/text/world_fields.h"

#include "core/document/text/fields.h"
#include "core/document/text/json.h"

namespace kerf {

namespace {

Status read_piece(const JsonValue& value, PieceId& piece) {
  const auto n = value.whole_numbers({3});
  if (!n) return value.wrong("must be three whole numbers: a body's slot, its generation and a label");
  piece = {{n->front(), (*n)[1]}, n->back()};
  return Done{};
}

nlohmann::ordered_json piece_json(const PieceId& piece) {
  return {piece.body.slot, piece.body.generation, piece.label};
}

// `always`: the meaning of a missing key that every version wrote.
template <typename Owner>
void number_field(Fields& f, const NumberField<Owner>& field, Owner& owner, const Missing<double>& always) {
  f.number(field.key, owner.*field.member, field.range,
           field.missing.always_written ? always : Missing<double>(field.missing.value));
}

}  // namespace

void describe(Fields& f, Pose& pose) {
  f.vector("origin", pose.origin);
  f.vector("direction", pose.direction, VectorRule::kUnit);
}

void describe(Fields& f, Placement& placement) {
  f.vector("position", placement.position);
  f.orientation("orientation", placement.orientation);
}

void piece_field(Fields& f, PieceId& piece) {
  f.value(
      "piece", [&](const JsonValue& value) { return read_piece(value, piece); },
      [&] { return piece_json(piece); });
}

static void describe(Fields& f, Substance& substance) {
  if (f.reading()) substance = substance_without_keys();
  for (const auto& field : kSubstanceFields) number_field(f, field, substance, kOptional);
}

void describe(Fields& f, Sheet& sheet) {
  number_field(f, kThickness, sheet, kNeeded);
  number_field(f, kDensity, sheet, kNeeded);
  for (const auto& field : kSubstanceFields) number_field(f, field, sheet.substance, kNeeded);
}

void scene_sheet_fields(Fields& f, Sheet& sheet) {
  number_field(f, kThickness, sheet, kThickness.missing.value);
  number_field(f, kDensity, sheet, kDensity.missing.value);
  if (f.reading()) sheet.substance = Substance();
  if (f.present("substance", sheet.substance != Substance())) f.object("substance", sheet.substance);
}

std::string left_open_text(const LeftOpen& open, const World& world) {
  return world.contains(open.body) ? world.body(open.body).own_name() + ": " + open.why : open.why;
}

}  // namespace kerf
