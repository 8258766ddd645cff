#include "core/document/command_words.h"

#include "core/base/length_text.h"

namespace kerf {

namespace {

struct Words {
  std::string operator()(const BeginStroke& c) const { return "Stroke, " + of(c.settings); }
  std::string operator()(const MoveStroke&) const { return "Move the beam"; }
  std::string operator()(const EndStroke&) const { return "End the stroke"; }
  std::string operator()(const Recut& c) const { return "Cut the stroke again, " + fineness(c.settings); }
  std::string operator()(const AddMesh& c) const { return "Add " + c.name; }
  std::string operator()(const MovePiece& c) const { return "Move " + of(c.piece); }
  std::string operator()(const HidePiece& c) const { return (c.hidden ? "Hide " : "Show ") + of(c.piece); }
  std::string operator()(const DeletePiece& c) const { return "Delete " + of(c.piece); }
  std::string operator()(const RenamePiece& c) const { return "Name " + of(c.piece) + " " + c.name; }
  std::string operator()(const Undo&) const { return "Undo"; }
  std::string operator()(const Redo&) const { return "Redo"; }

  static std::string of(const CutSettings& s) {
    return "radius " + length_text(s.laser.radius) +
           (s.laser.pattern == Pattern::kRays4 ? ", four rays" : "");
  }
  static std::string fineness(const CutSettings& s) {
    const Resolution& r = s.resolution;
    switch (r.rule) {
      case Resolution::Rule::kTargetEdge:
        return "edges of " + length_text(r.target_edge);
      case Resolution::Rule::kTolerance:
        return "within " + length_text(r.tolerance);
      case Resolution::Rule::kDepth:
        return std::to_string(r.depth) + (r.depth == 1 ? " level" : " levels");
    }
    return "";
  }
  static std::string of(const PieceId& piece) {
    if (piece.label == 0) return "body " + std::to_string(piece.body.slot + 1);
    return "piece " + std::to_string(piece.label) + " of body " + std::to_string(piece.body.slot + 1);
  }
};

struct Weight {
  size_t operator()(const AddMesh& c) const { return c.file.native().size() + c.name.size(); }
  size_t operator()(const RenamePiece& c) const { return c.name.size(); }
  size_t operator()(const auto&) const { return 0; }
};

}  // namespace

std::string words(const Command& command) { return std::visit(Words{}, command); }

size_t weight(const Command& command) { return sizeof(Command) + std::visit(Weight{}, command); }

}  // namespace kerf
