#include "core/document/commands/piece_commands.h"

#include "core/document/commands/edit_piece.h"
#include "core/document/text/fields.h"
#include "core/document/text/world_fields.h"
#include "core/edit/detach.h"
#include "core/world/solid_body.h"

namespace kerf {

std::string MovePiece::words(const std::string& piece_name) const { return "Move " + piece_name; }

void describe(Fields& f, MovePiece& c) {
  piece_field(f, c.piece);
  describe(f, c.to);
}

Result<Delta> MovePiece::run(World& world, uint32_t generation, const Progress*) const {
  return edit_piece(
      world, piece, generation, &Delta::moved, [&](const Body& body) { return body.placement != to; },
      [&](Body& own) {
        own.placement = to;
        own.motion = {};
      });
}

std::string DuplicatePiece::words(const std::string& piece_name) const { return "Duplicate " + piece_name; }

void describe(Fields& f, DuplicatePiece& c) {
  piece_field(f, c.piece);
  describe(f, c.to);
}

Result<Delta> DuplicatePiece::run(World& world, uint32_t generation, const Progress*) const {
  if (!has_faces(world, piece)) return no_such_piece(piece);
  Delta delta;
  const BodyId copy = duplicate(world, piece, generation, delta);
  world.body(copy).placement = to;
  return delta;
}

std::string HidePiece::words(const std::string& piece_name) const {
  return (hidden ? "Hide " : "Show ") + piece_name;
}

void describe(Fields& f, HidePiece& c) {
  piece_field(f, c.piece);
  f.flag("hidden", c.hidden);
}

Result<Delta> HidePiece::run(World& world, uint32_t generation, const Progress*) const {
  return edit_piece(
      world, piece, generation, &Delta::hid_or_showed,
      [&](const Body& body) { return body.hidden != hidden; }, [&](Body& own) { own.hidden = hidden; });
}

std::string DeletePiece::words(const std::string& piece_name) const { return "Delete " + piece_name; }

void describe(Fields& f, DeletePiece& c) { piece_field(f, c.piece); }

Result<Delta> DeletePiece::run(World& world, uint32_t generation, const Progress*) const {
  if (!has_faces(world, piece)) return no_such_piece(piece);
  Delta delta, change;
  change.went = {detach(world, piece, generation, delta)};
  world.remove(change.went.front());
  delta.append(std::move(change));
  return delta;
}

std::string RenamePiece::words(const std::string& piece_name) const {
  return "Name " + piece_name + " " + name;
}

void describe(Fields& f, RenamePiece& c) {
  piece_field(f, c.piece);
  f.text("name", c.name);
}

Result<Delta> RenamePiece::run(World& world, uint32_t, const Progress*) const {
  if (!has_faces(world, piece)) return no_such_piece(piece);
  Delta delta;
  Body& body = world.body(piece.body);
  if (body.name_of(piece.label) == name) return delta;
  if (stands_alone(world, piece)) {
    body.name = name;
    body.named = piece.label;
    body.piece_names.clear();
  } else {
    body.piece_names[piece.label] = name;
  }
  delta.renamed = {piece.body};
  return delta;
}

std::string PinPiece::words(const std::string& piece_name) const {
  return (pinned ? "Pin " : "Unpin ") + piece_name;
}

void describe(Fields& f, PinPiece& c) {
  piece_field(f, c.piece);
  f.flag("pinned", c.pinned);
}

Result<Delta> PinPiece::run(World& world, uint32_t generation, const Progress*) const {
  return edit_piece(
      world, piece, generation, &Delta::pinned, [&](const Body& body) { return body.pinned != pinned; },
      [&](Body& own) {
        own.pinned = pinned;
        own.motion = {};
      });
}

std::string SetSheetProperties::words(const std::string& piece_name) const {
  return "Material of " + piece_name;
}

void describe(Fields& f, SetSheetProperties& c) {
  piece_field(f, c.piece);
  describe(f, c.sheet);
}

Result<Delta> SetSheetProperties::run(World& world, uint32_t generation, const Progress*) const {
  return edit_piece(
      world, piece, generation, &Delta::reweighed, [&](const Body& body) { return body.sheet != sheet; },
      [&](Body& own) { own.sheet = sheet; });
}

std::string SetSolid::words(const std::string& piece_name) const {
  return piece_name + (solid ? " as a solid" : " as a sheet");
}

void describe(Fields& f, SetSolid& c) {
  piece_field(f, c.piece);
  f.flag("solid", c.solid);
}

Result<Delta> SetSolid::run(World& world, uint32_t generation, const Progress*) const {
  return edit_piece(
      world, piece, generation, &Delta::reweighed, [&](const Body& body) { return body.solid != solid; },
      [&](Body& own) { make_solid(own, solid); });
}

}  // namespace kerf
