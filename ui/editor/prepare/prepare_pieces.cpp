#include "ui/editor/prepare/prepare_pieces.h"

#include <algorithm>
#include <cmath>

#include "core/base/assert.h"

namespace kerf {

namespace {

constexpr size_t kMostFaces = 16'000'000;  // that a subdivision may lead to

// The share of a piece in a number of faces for all pieces.
size_t share_of_faces(const PieceRow& piece, const FaceForecast& all, size_t faces) {
  const double share = static_cast<double>(piece.faces) / static_cast<double>(all.before);
  return std::max<size_t>(1, static_cast<size_t>(std::floor(share * static_cast<double>(faces))));
}

// The commands for one piece. What they do to it must be followed from one to the next.
std::vector<Command> commands_for(const PieceRow& row, const FaceForecast& all, const Preparation& p) {
  using Tool = Preparation::Tool;
  switch (p.tool) {
    case Tool::kSimplifyToFaces:
      return {SimplifyPiece{row.id, {.faces = share_of_faces(row, all, p.faces)}}};
    case Tool::kSimplifyToError:
      return {SimplifyPiece{row.id, {.error = p.error}}};
    case Tool::kSubdivide:
      return std::vector<Command>(p.times, SubdividePiece{row.id, p.scheme});
    case Tool::kTurnShells:
      return {TurnShells{row.id}};
    case Tool::kSmooth:
      break;
  }
  return {SmoothPiece{row.id, p.times}};
}

void rename(Command& command, const Delta& delta) {
  std::visit(
      [&](auto& c) {
        if constexpr (requires { c.piece; }) c.piece = named_after(delta, c.piece);
      },
      command);
}

}  // namespace

std::vector<PieceRow> pieces_to_prepare(const World& world, const PieceMap& looks) {
  std::vector<PieceRow> rows = list_pieces(world, looks);
  if (chosen_pieces(looks) == 0) return rows;
  std::erase_if(rows, [&](const PieceRow& row) {
    const auto look = looks.find(row.id);
    return look == looks.end() || !look->second.selected;
  });
  return rows;
}

FaceForecast forecast(std::span<const PieceRow> pieces, const Preparation& p) {
  FaceForecast faces;
  for (const PieceRow& row : pieces) faces.before += row.faces;
  switch (p.tool) {
    case Preparation::Tool::kSimplifyToFaces:
      faces.after = std::min(faces.before, std::max(p.faces, pieces.size()));
      break;
    case Preparation::Tool::kSimplifyToError:
      break;
    case Preparation::Tool::kSubdivide:
      faces.after = faces.before;
      for (size_t i = 0; i < p.times && *faces.after <= kMostFaces; ++i)
        *faces.after *= parts_of_face(p.scheme);
      break;
    case Preparation::Tool::kSmooth:
    case Preparation::Tool::kTurnShells:
      faces.after = faces.before;
      break;
  }
  return faces;
}

const char* preparation_title(Preparation::Tool tool) {
  if (tool == Preparation::Tool::kSubdivide) return "Subdividing";
  if (tool == Preparation::Tool::kTurnShells) return "Turning inner shells";
  return tool == Preparation::Tool::kSmooth ? "Smoothing" : "Simplifying";
}

const char* why_no_preparation(std::span<const PieceRow> pieces, const Preparation& p) {
  const FaceForecast faces = forecast(pieces, p);
  if (faces.before == 0) return "There are no faces.";
  if (p.tool == Preparation::Tool::kSubdivide && *faces.after > kMostFaces)
    return "That would make more than 16 million faces.";
  if (p.tool == Preparation::Tool::kSimplifyToFaces && p.faces >= faces.before)
    return "There are no more faces than that.";
  return nullptr;
}

Outcome prepare_pieces(Document& document, std::span<const PieceRow> pieces, const Preparation& preparation,
                       const Progress* progress) {
  KERF_ASSERT(why_no_preparation(pieces, preparation) == nullptr);
  const FaceForecast faces = forecast(pieces, preparation);
  std::vector<Command> commands;
  std::vector<double> shares;  // of the time
  for (const PieceRow& row : pieces) {
    const std::vector<Command> own = commands_for(row, faces, preparation);
    commands.insert(commands.end(), own.begin(), own.end());
    const double share = static_cast<double>(row.faces) / static_cast<double>(faces.before);
    shares.insert(shares.end(), own.size(), share / static_cast<double>(own.size()));
  }
  const size_t from = document.history().position();
  Outcome all;
  ProgressShares progress_shares(progress);
  for (size_t i = 0; i < commands.size() && all.ok(); ++i) {
    const Progress own = progress_shares.next(shares[i]);
    Outcome one = document.apply(commands[i], progress ? &own : nullptr);
    for (Command& command : commands) rename(command, one.delta);
    all.append(std::move(one));
  }
  if (all.ok()) return all;
  Outcome undone(std::move(all.delta));
  undone.append(document.travel(from));
  const bool stopped = all.error().message == cancelled().message;
  undone.fail(stopped ? failed("It was stopped: nothing was changed.") : all.error());
  return undone;
}

}  // namespace kerf
