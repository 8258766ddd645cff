#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/world/world.h"
#include "ui/render/view_options.h"

namespace kerf {

using PieceMap = std::map<PieceId, PieceLook>;

struct PieceRow {
  PieceId id;
  std::string name;
  size_t faces = 0;
  double area = 0;  // m^2
};

// The pieces that have faces: the bodies themselves first, then what came off, the largest area first.
std::vector<PieceRow> list_pieces(const World& world);

// The colour that the renderer gives to what came off (sRGB, 0 .. 1); grey for a body itself. `strong` as
// with ShowOptions::pieces.
Vec3 piece_colour(uint32_t label, bool strong);

// Makes a piece the chosen one, or with `add` one more of them; one that is chosen already is let go.
void choose_piece(PieceMap& looks, const PieceId& id, bool add);
void choose_none(PieceMap& looks);
size_t chosen_pieces(const PieceMap& looks);
// The first of those; none where there is none.
std::optional<PieceId> first_chosen(const PieceMap& looks);
std::vector<PieceId> hidden_pieces(const PieceMap& looks);

// Hides what the world hides, forgets what has no faces any more, and finds again what went by a new body
// when a piece was detached.
void follow_world(const World& world, PieceMap& looks);

// Sets every piece's offset to `spread` times the way from the middle of the world to its own middle (the
// mean of its faces' by area). O(faces) where the spread is not 0.
void spread_pieces(const World& world, double spread, PieceMap& looks);

}  // namespace kerf
