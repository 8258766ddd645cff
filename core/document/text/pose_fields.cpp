#include "core/document/text/pose_fields.h"

#include "core/document/text/fields.h"
#include "core/document/text/json_value.h"

namespace kerf {

namespace {

Status read_piece(const JsonValue& value, PieceId& piece) {
  const auto n = value.whole_numbers({2, 3});
  if (!n) return value.wrong("must be three whole numbers: a body's slot, its generation and a label");
  piece = {{n->front(), n->size() == 3 ? (*n)[1] : BodyId::kUnknownGeneration}, n->back()};
  return Done{};
}

nlohmann::ordered_json piece_json(const PieceId& piece) {
  if (piece.body.generation == BodyId::kUnknownGeneration) return {piece.body.slot, piece.label};
  return {piece.body.slot, piece.body.generation, piece.label};
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

}  // namespace kerf
