#include "ui/editor/shared/command_labels.h"

#include <array>
#include <cstdio>

#include "core/document/extract.h"

namespace kerf {

namespace {

std::string close_sentence(size_t removed) {
  if (removed == 0) return "Close the rim: no face was left inside the boundary of the stroke.";
  return "Close the rim: " + count_text(removed, "face") + " inside the boundary of the stroke " +
         (removed == 1 ? "was" : "were") + " removed.";
}

// "1 face was", "3 faces were", "no face was".
std::string faces_were(size_t count) {
  if (count == 0) return "no face was";
  return count_text(count, "face") + (count == 1 ? " was" : " were");
}

size_t count_new_pieces(const Delta& delta) {
  size_t all = 0;
  for (const BodyDelta& body : delta.bodies) all += body.new_pieces.size();
  return all;
}

std::string sweep_sentence(const StageRecord& record, FileUnit unit) {
  const double way = glm::length(record.move->to.origin - record.move->from.origin);
  const std::string moves = way > 0 ? "moves by " + length_label(way, unit) : "stays in place";
  return "Sweep: the origin of the beam " + moves + "; the beam sweeps " +
         count_text(record.beam.size(), "volume") + " of radius " +
         length_label(record.beam.front().radius(), unit) + ".";
}

std::string separate_sentence(size_t pieces, size_t specks) {
  std::string all = pieces > 0 ? count_text(pieces, "piece") : "";
  if (specks > 0) all += (all.empty() ? "" : ", ") + count_text(specks, "speck");
  return "Separate: " + (all.empty() ? "no piece" : all) + " came off.";
}

std::string left_sentence(const StageRecord& record) {
  if (record.left == 0) return "";
  return " " + count_text(record.left, "face") + (record.left == 1 ? " is" : " are") +
         " left for this stage.";
}

// The label of each kind of command.
struct CommandLabel {
  const std::string& piece;
  FileUnit unit;

  std::string operator()(const BeginStroke& c) const {
    return "Stroke, " + beam_label(c.settings.laser, unit);
  }
  std::string operator()(const MoveBeam&) const { return "Move the beam"; }
  std::string operator()(const EndStroke&) const { return "End the stroke"; }
  std::string operator()(const StopStroke&) const { return "Stop the stroke"; }
  std::string operator()(const Recut& c) const {
    return "Recut the stroke, " + resolution_label(c.settings.resolution, unit);
  }
  std::string operator()(const AdvanceTime& c) const { return c.bodies ? "Time with moving bodies" : "Time"; }
  std::string operator()(const DragBody&) const { return "Drag " + piece; }
  std::string operator()(const ReleaseBody&) const { return "Release"; }
  std::string operator()(const Play&) const { return "Play"; }
  std::string operator()(const AddMesh& c) const { return "Add " + c.name; }
  std::string operator()(const MovePiece&) const { return "Move " + piece; }
  std::string operator()(const DuplicatePiece&) const { return "Duplicate " + piece; }
  std::string operator()(const HidePiece& c) const { return (c.hidden ? "Hide " : "Show ") + piece; }
  std::string operator()(const DeletePiece&) const { return "Delete " + piece; }
  std::string operator()(const RenamePiece& c) const { return "Rename " + piece + " to " + c.name; }
  std::string operator()(const PinPiece& c) const { return (c.pinned ? "Pin " : "Unpin ") + piece; }
  std::string operator()(const SetSheetProperties&) const { return "Set material of " + piece; }
  std::string operator()(const SetSolid& c) const {
    if (!c.cut_material.empty()) return "Set cut material of " + piece;
    return "Make " + piece + (c.solid ? " a solid" : " a sheet");
  }
  std::string operator()(const SimplifyPiece&) const { return "Simplify " + piece; }
  std::string operator()(const SubdividePiece&) const { return "Subdivide " + piece; }
  std::string operator()(const SmoothPiece& c) const {
    return "Smooth " + piece + (c.times == 1 ? "" : ", " + std::to_string(c.times) + " times");
  }
  std::string operator()(const TurnShells&) const { return "Turn inner shells of " + piece; }
  std::string operator()(const CutPlane&) const { return "Cut along a plane"; }
  std::string operator()(const CutPath&) const { return "Cut with the knife"; }
  std::string operator()(const JoinParts&) const { return "Join parts of " + piece; }
  std::string operator()(const SetEnvironment&) const { return "Set gravity and ground"; }
  std::string operator()(const Undo&) const { return "Undo"; }
  std::string operator()(const Redo&) const { return "Redo"; }
};

}  // namespace

LengthUnit label_unit(double length, FileUnit unit) {
  if (unit == FileUnit::kInch) return {"in", 1};
  const double metres = metres_per_unit(unit);
  const LengthUnit shown = unit_for(length * metres);
  return {shown.name, shown.metres / metres};
}

std::string length_label(double length, FileUnit unit) {
  const LengthUnit shown = label_unit(length, unit);
  std::array<char, 48> text{};
  std::snprintf(text.data(), text.size(), "%.3g %s", length / shown.metres, shown.name);
  return text.data();
}

std::string resolution_label(const Resolution& resolution, FileUnit unit) {
  switch (resolution.rule) {
    case Resolution::Rule::kTargetEdge:
      return "edges of " + length_label(resolution.target_edge, unit);
    case Resolution::Rule::kTolerance:
      return "within " + length_label(resolution.tolerance, unit);
    case Resolution::Rule::kDepth:
      return std::to_string(resolution.depth) + (resolution.depth == 1 ? " level" : " levels");
  }
  return "";
}

std::string beam_label(const Laser& laser, FileUnit unit) {
  return "radius " + length_label(laser.radius, unit) +
         (laser.pattern == Pattern::kRays4 ? ", four rays" : "");
}

std::string command_label(const Command& command, FileUnit unit, const std::string& piece_name) {
  const std::optional<PieceId> piece = piece_of(command);
  const std::string name = piece && piece_name.empty() ? piece_words(*piece) : piece_name;
  return std::visit(CommandLabel{name, unit}, command);
}

std::string stage_label(const StageRecord& record, FileUnit unit) {
  const StepStatistics& statistics = record.done.statistics;
  switch (record.kind) {
    case StageRecord::Kind::kSweep:
      return sweep_sentence(record, unit);
    case StageRecord::Kind::kHit:
    case StageRecord::Kind::kHitAgain:
      return std::string(record.kind == StageRecord::Kind::kHit ? "Hit" : "Hit again, after refinement") +
             ": the beam touches " + count_text(record.hit.size(), "face") + "; the tree tested " +
             count_text(statistics.tested.boxes, "box slot") + " and " +
             count_text(statistics.tested.faces, "face") + ".";
    case StageRecord::Kind::kRefine:
      return "Refine: " + faces_were(statistics.faces_made) + " created by splits." + left_sentence(record);
    case StageRecord::Kind::kRemove:
      return "Remove: " + faces_were(record.done.delta.removed_faces) + " removed." + left_sentence(record);
    case StageRecord::Kind::kSeparate:
      return separate_sentence(count_new_pieces(record.done.delta) - record.specks, record.specks);
    case StageRecord::Kind::kCloseRim:
      return close_sentence(record.done.delta.removed_faces);
    case StageRecord::Kind::kTime:
      return "Time: a tick passed.";
  }
  return {};
}

}  // namespace kerf
