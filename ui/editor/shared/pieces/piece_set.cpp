#include "ui/editor/shared/pieces/piece_set.h"

#include <cmath>

#include "core/document/commands/edit_piece.h"
#include "core/joints/loaded_part.h"

namespace kerf {

void drop_plain(PieceMap& looks) {
  std::erase_if(looks, [](const auto& entry) { return entry.second == PieceLook(); });
}

namespace {

std::string name_of(const World& world, const PieceRow& row) {
  const Body& body = world.body(row.id.body);
  if (row.id.label == body.named || body.piece_names.contains(row.id.label))
    return body.name_of(row.id.label);
  const std::string part = row.part ? loaded_part_name(world, row.id) : "";
  return part.empty() ? body.name + " " + std::to_string(row.part ? row.id.label : row.number) : part;
}

// Bodies, pieces, parts.
int kind_of(const PieceRow& row) { return row.part ? 2 : row.id.label == 0 ? 0 : 1; }

double fraction(double x) { return x - std::floor(x); }

// As hue_colour of body.vert: linear light of a hue (0 .. 1), a saturation and a lightness.
Vec3 hue_colour(double hue, double saturation, double value) {
  const Vec3 turned = glm::abs(glm::fract(Vec3(hue, hue + 2.0 / 3, hue + 1.0 / 3)) * 6.0 - 3.0) - 1.0;
  return value * glm::mix(Vec3(1), glm::clamp(turned, 0.0, 1.0), saturation);
}

}  // namespace

std::vector<PieceRow> list_pieces(const World& world, const PieceMap& looks) {
  std::vector<PieceRow> rows;
  for (const BodyId id : world.ids()) {
    const Body& body = world.body(id);
    for (uint32_t label = 0; label < body.pieces.size(); ++label) {
      const Piece& piece = body.pieces[label];
      if (piece.faces == 0) continue;
      const auto look = looks.find({id, label});
      const uint32_t number = look != looks.end() && look->second.number != 0 ? look->second.number : label;
      const bool part = is_loaded_part(body, label);
      PieceRow& row = rows.emplace_back();
      row = {{id, label}, part ? 0 : number, "", piece.faces, piece.area, body.pinned, part};
      row.name = name_of(world, row);
    }
  }
  std::stable_sort(rows.begin(), rows.end(), [](const PieceRow& a, const PieceRow& b) {
    return kind_of(a) != kind_of(b) ? kind_of(a) < kind_of(b) : a.area > b.area;
  });
  return rows;
}

SortedPieces set_specks_apart(std::vector<PieceRow> rows, const std::set<PieceId>& specks) {
  const auto is_one = [&](const PieceRow& row) { return specks.contains(row.id); };
  SortedPieces sorted;
  if (std::count_if(rows.begin(), rows.end(), is_one) < 2) {
    sorted.rest = std::move(rows);
    return sorted;
  }
  for (PieceRow& row : rows) (is_one(row) ? sorted.specks : sorted.rest).push_back(std::move(row));
  return sorted;
}

Vec3 strong_piece_colour(uint32_t number) {
  if (number == 0) return Vec3(0.45);
  const double turn = fraction(number * 0.61803399), shade = fraction(number * 0.7548777);
  return glm::pow(hue_colour(turn, 0.80, 0.40 + 0.25 * shade), Vec3(1 / 2.2));
}

void choose_piece(PieceMap& looks, const PieceId& id, bool add) {
  const auto found = looks.find(id);
  const bool was = found != looks.end() && found->second.selected;
  const bool alone = was && chosen_pieces(looks) == 1;
  if (!add) choose_none(looks);
  looks[id].selected = add ? !was : !alone;
  drop_plain(looks);
}

void choose_none(PieceMap& looks) {
  for (auto& [id, look] : looks) look.selected = false;
  drop_plain(looks);
}

size_t chosen_pieces(const PieceMap& looks) {
  return static_cast<size_t>(
      std::count_if(looks.begin(), looks.end(), [](const auto& entry) { return entry.second.selected; }));
}

const char* why_none_chosen(const PieceMap& looks) {
  return chosen_pieces(looks) > 0 ? nullptr : "No piece is chosen: Ctrl+click one, or choose it in the list.";
}

std::optional<PieceId> first_chosen(const PieceMap& looks) {
  for (const auto& [key, look] : looks) {
    if (look.selected) return key;
  }
  return std::nullopt;
}

std::vector<PieceId> hidden_pieces(const PieceMap& looks) {
  std::vector<PieceId> hidden;
  for (const auto& [id, look] : looks) {
    if (look.hidden) hidden.push_back(id);
  }
  return hidden;
}

std::vector<PieceId> other_pieces(const World& world, const PieceMap& looks) {
  std::vector<PieceId> others;
  for (const PieceRow& row : list_pieces(world)) {
    const auto look = looks.find(row.id);
    if (look == looks.end() || !(look->second.hidden || look->second.selected)) others.push_back(row.id);
  }
  return others;
}

PieceId named_after(const Delta& delta, PieceId id) {
  // One after the other: what was detached may be detached from again.
  for (const Detached& d : delta.detached) {
    if (id == PieceId{d.from, d.label}) id.body = d.to;
  }
  return id;
}

void follow_world(const World& world, const Delta& delta, PieceMap& looks) {
  PieceMap now;
  for (const auto& [before, look] : looks) {
    const PieceId id = named_after(delta, before);
    if (has_faces(world, id)) now[id] = look;
  }
  for (auto& [id, look] : now) look.hidden = false;
  for (const BodyId id : world.ids()) {
    const Body& body = world.body(id);
    for (uint32_t label = 0; body.hidden && label < body.pieces.size(); ++label) {
      if (body.pieces[label].faces == 0) continue;
      now[{id, label}].hidden = true;
      now[{id, label}].selected = false;
    }
  }
  drop_plain(now);
  looks = std::move(now);
}

}  // namespace kerf
