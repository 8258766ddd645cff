#include "ui/editor/shared/piece_set.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/base/assert.h"
#include "core/document/extract.h"
#include "core/edit/separation.h"
#include "core/joints/joined_parts.h"
#include "ui/render/bodies/body_picture.h"

namespace kerf {

void drop_plain(PieceMap& looks) {
  std::erase_if(looks, [](const auto& entry) { return entry.second == PieceLook(); });
}

namespace {

// See PieceLook::number.
uint32_t number_in(const PieceMap& looks, const PieceId& id) {
  const auto look = looks.find(id);
  return look != looks.end() && look->second.number != 0 ? look->second.number : id.label;
}

// Bodies, pieces, parts.
int kind_of(const PieceRow& row) { return row.part ? 2 : row.id.label == 0 ? 0 : 1; }

double fraction(double x) { return x - std::floor(x); }

// As hue_colour of body.vert: linear light of a hue (0 .. 1), a saturation and a lightness.
Vec3 hue_colour(double hue, double saturation, double value) {
  const Vec3 turned = glm::abs(glm::fract(Vec3(hue, hue + 2.0 / 3, hue + 1.0 / 3)) * 6.0 - 3.0) - 1.0;
  return value * glm::mix(Vec3(1), glm::clamp(turned, 0.0, 1.0), saturation);
}

// The difference of two pieces that may be the same part cut differently: the squared distance of their
// centres in terms of their area, plus the squared relative excess of area. From kOther on they are
// different parts.
constexpr double kOther = 0.25;

bool all_settled(const World& world) {
  const std::vector<BodyId> ids = world.ids();
  return std::all_of(ids.begin(), ids.end(), [&](BodyId id) { return kerf::is_settled(world.body(id)); });
}

}  // namespace

std::string name_of_piece(const World& world, const PieceMap& looks, const PieceId& id) {
  const Body& body = world.body(id.body);
  if (id.label == body.named || body.piece_names.contains(id.label)) return body.name_of(id.label);
  const bool part = id.label < body.pieces.size() && is_loaded_part(body, id.label);
  const std::string in_file = part ? loaded_part_name(world, id) : "";
  if (!in_file.empty()) return in_file;
  return body.name + " " + std::to_string(part ? id.label : number_in(looks, id));
}

std::vector<PieceRow> list_pieces(const World& world, const PieceMap& looks) {
  std::vector<PieceRow> rows;
  for (const BodyId id : world.ids()) {
    const Body& body = world.body(id);
    for (uint32_t label = 0; label < body.pieces.size(); ++label) {
      const Piece& piece = body.pieces[label];
      if (piece.faces == 0) continue;
      const bool part = is_loaded_part(body, label);
      const uint32_t number = part ? 0 : number_in(looks, {id, label});
      const std::string name = name_of_piece(world, looks, {id, label});
      rows.push_back({{id, label}, number, name, piece.faces, piece.area, body.pinned, part});
    }
  }
  std::stable_sort(rows.begin(), rows.end(), [](const PieceRow& a, const PieceRow& b) {
    return kind_of(a) != kind_of(b) ? kind_of(a) < kind_of(b) : a.area > b.area;
  });
  return rows;
}

void sort_pieces(std::vector<PieceRow>& rows, PieceColumn column, bool is_descending) {
  std::ranges::sort(rows, [&](const PieceRow& left, const PieceRow& right) {
    const PieceRow &a = is_descending ? right : left, &b = is_descending ? left : right;
    if (column == PieceColumn::kFaces && a.faces != b.faces) return a.faces < b.faces;
    if (column == PieceColumn::kArea && a.area != b.area) return a.area < b.area;
    if (kind_of(a) != kind_of(b)) return kind_of(a) < kind_of(b);
    return a.number != b.number ? a.number < b.number : a.id < b.id;
  });
}

SortedPieces separate_specks(std::vector<PieceRow> rows, const std::set<PieceId>& specks) {
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

void select_piece(PieceMap& looks, const PieceId& id, bool add) {
  const auto found = looks.find(id);
  if (found != looks.end() && found->second.hidden) return;
  const bool was = found != looks.end() && found->second.selected;
  const bool alone = was && selected_count(looks) == 1;
  if (!add) deselect_all(looks);
  looks[id].selected = add ? !was : !alone;
  drop_plain(looks);
}

void deselect_all(PieceMap& looks) {
  for (auto& [id, look] : looks) look.selected = false;
  drop_plain(looks);
}

size_t selected_count(const PieceMap& looks) {
  return static_cast<size_t>(
      std::count_if(looks.begin(), looks.end(), [](const auto& entry) { return entry.second.selected; }));
}

const char* no_selection_reason(const PieceMap& looks) {
  return selected_count(looks) > 0 ? nullptr
                                   : "Select a piece first: Ctrl+click it, or click it in the Pieces list.";
}

std::optional<PieceId> first_selected(const PieceMap& looks) {
  for (const auto& [key, look] : looks) {
    if (look.selected) return key;
  }
  return std::nullopt;
}

namespace {

Bounds bounds_as_drawn(const World& world, const ViewOptions& options, bool only_selected) {
  Bounds bounds = Bounds::none();
  for (const BodyId id : world.ids()) {
    const Body& body = world.body(id);
    const BodyLooks looks(id, body, options);
    for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
      if (!body.mesh.is_live(FaceId(f))) continue;
      const PieceLook& look = looks.of(body.mesh, FaceId(f));
      if (only_selected && !look.selected) continue;
      for (const Vec3& corner : body.mesh.triangle(FaceId(f)))
        bounds.add(look.turn * body.placement.to_world(corner) + look.offset);
    }
  }
  return bounds;
}

}  // namespace

Bounds selected_bounds(const World& world, const ViewOptions& options) {
  return bounds_as_drawn(world, options, true);
}

Bounds drawn_bounds(const World& world, const ViewOptions& options) {
  const bool any_displaced =
      std::ranges::any_of(options.pieces, [](const auto& entry) { return entry.second.is_away(); });
  const Bounds bounds = any_displaced ? bounds_as_drawn(world, options, false) : Bounds::none();
  return bounds.is_none() ? world.bounds() : bounds;
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
  // In order, because a detached piece may be detached from again.
  for (const Detached& d : delta.detached) {
    if (id == PieceId{d.from, d.label}) id.body = d.to;
  }
  return id;
}

void follow_world(const World& world, const Delta& delta, std::vector<PieceId>& pieces) {
  for (PieceId& piece : pieces) piece = named_after(delta, piece);
  std::erase_if(pieces, [&](const PieceId& piece) { return !has_faces(world, piece); });
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

std::vector<PieceNumbers::Known> PieceNumbers::pieces_of(const World& world) {
  std::vector<Known> pieces;
  for (const BodyId id : world.ids()) {
    const Body& body = world.body(id);
    for (uint32_t label = 1; label < body.pieces.size(); ++label) {
      const Piece& p = body.pieces[label];
      if (p.faces == 0) continue;
      const Vec3 centre = body.middle() + (p.area > 0 ? p.moments.first / p.area : Vec3(0));
      pieces.push_back({{id, label}, body.loaded_as, 0, p.area, body.placement.to_world(centre)});
    }
  }
  return pieces;
}

void PieceNumbers::follow(const World& world, bool replaced, bool may_return, PieceMap& looks) {
  replaced_ = replaced_ || replaced;
  waits_ = !all_settled(world);
  if (waits_) return;
  std::map<PieceId, Known*> present;
  std::vector<std::optional<PieceId>> before;
  for (Known& known : known_) {
    if (known.present && !replaced_) present.emplace(known.id, &known);
    before.push_back(known.present ? std::optional(known.id) : std::nullopt);
    known.present = false;
  }
  std::vector<Known> created;
  for (Known& piece : pieces_of(world)) {
    const auto same = present.find(piece.id);
    if (same == present.end()) {
      created.push_back(piece);
    } else {
      piece.number = same->second->number;
      *same->second = piece;
    }
  }
  replaced_ = false;
  match(created);
  if (replaced) move_selection(before, looks);
  if (!may_return) std::erase_if(known_, [](const Known& k) { return !k.present; });
  for (const Known& known : known_) {
    if (known.present) looks[known.id].number = known.number == known.id.label ? 0 : known.number;
  }
  drop_plain(looks);
}

// Matches the most similar pairs first.
void PieceNumbers::match(std::vector<Known>& created) {
  std::vector<std::tuple<double, size_t, size_t>> pairs;
  for (size_t i = 0; i < created.size(); ++i) {
    for (size_t j = 0; j < known_.size(); ++j) {
      const Known &a = created[i], &b = known_[j];
      const double larger = std::max(a.area, b.area);
      if (b.present || a.loaded_as != b.loaded_as || !(larger > 0)) continue;
      const Vec3 apart = a.centre - b.centre;
      const double more = (a.area - b.area) / larger, differ = glm::dot(apart, apart) / larger + more * more;
      if (differ < kOther) pairs.emplace_back(differ, i, j);
    }
  }
  std::sort(pairs.begin(), pairs.end());
  for (const auto& [differ, i, j] : pairs) {
    if (created[i].number != 0 || known_[j].present) continue;
    created[i].number = known_[j].number;
    known_[j] = created[i];
  }
  for (Known& piece : created) {
    if (piece.number != 0) continue;
    piece.number = free_number(piece);
    known_.push_back(piece);
  }
}

// Moves the selection with the pieces whose labels changed within their body. `before`: the earlier ids of
// the first known pieces, nullopt for missing ones.
void PieceNumbers::move_selection(const std::vector<std::optional<PieceId>>& before, PieceMap& looks) const {
  KERF_ASSERT(before.size() <= known_.size());
  const auto was_selected = [&](const PieceId& id) {
    const auto look = looks.find(id);
    return look != looks.end() && look->second.selected;
  };
  std::map<PieceId, bool> now;
  std::vector<PieceId> left;
  for (size_t i = 0; i < before.size(); ++i) {
    const Known& known = known_[i];
    if (!before[i] || !known.present || before[i]->body != known.id.body) continue;
    now[known.id] = was_selected(*before[i]);
    if (*before[i] != known.id) left.push_back(*before[i]);
  }
  for (const PieceId& id : left) now.emplace(id, false);
  for (const auto& [id, is_selected] : now) looks[id].selected = is_selected;
}

// Returns its label, unless another piece of the same body has that number.
uint32_t PieceNumbers::free_number(const Known& piece) const {
  uint32_t most = 0;
  bool taken = false;
  for (const Known& known : known_) {
    if (known.loaded_as != piece.loaded_as) continue;
    most = std::max(most, known.number);
    taken = taken || known.number == piece.id.label;
  }
  return taken ? std::max(most, piece.id.label) + 1 : piece.id.label;
}

}  // namespace kerf
