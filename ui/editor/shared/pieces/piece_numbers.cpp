#include "ui/editor/shared/pieces/piece_numbers.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "core/edit/separation.h"

namespace kerf {

namespace {

// How much two pieces differ that may be the same part cut differently: the squared distance of their centres
// in terms of their area, plus the squared share of area that one has more. From kOther on they are others.
constexpr double kOther = 0.25;

bool all_settled(const World& world) {
  const std::vector<BodyId> ids = world.ids();
  return std::all_of(ids.begin(), ids.end(), [&](BodyId id) { return kerf::is_settled(world.body(id)); });
}

}  // namespace

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

void PieceNumbers::follow(const World& world, bool anew, bool may_return, PieceMap& looks) {
  anew_ = anew_ || anew;
  waits_ = !all_settled(world);
  if (waits_) return;
  std::map<PieceId, Known*> present;
  for (Known& known : known_) {
    if (known.present && !anew_) present.emplace(known.id, &known);
    known.present = false;
  }
  std::vector<Known> came;
  for (Known& piece : pieces_of(world)) {
    const auto same = present.find(piece.id);
    if (same == present.end()) {
      came.push_back(piece);
    } else {
      piece.number = same->second->number;
      *same->second = piece;
    }
  }
  anew_ = false;
  match(came);
  if (!may_return) std::erase_if(known_, [](const Known& k) { return !k.present; });
  for (const Known& known : known_) {
    if (known.present) looks[known.id].number = known.number == known.id.label ? 0 : known.number;
  }
  drop_plain(looks);
}

// The pairs that differ least first.
void PieceNumbers::match(std::vector<Known>& came) {
  std::vector<std::tuple<double, size_t, size_t>> pairs;
  for (size_t i = 0; i < came.size(); ++i) {
    for (size_t j = 0; j < known_.size(); ++j) {
      const Known &a = came[i], &b = known_[j];
      const double larger = std::max(a.area, b.area);
      if (b.present || a.loaded_as != b.loaded_as || !(larger > 0)) continue;
      const Vec3 apart = a.centre - b.centre;
      const double more = (a.area - b.area) / larger, differ = glm::dot(apart, apart) / larger + more * more;
      if (differ < kOther) pairs.emplace_back(differ, i, j);
    }
  }
  std::sort(pairs.begin(), pairs.end());
  for (const auto& [differ, i, j] : pairs) {
    if (came[i].number != 0 || known_[j].present) continue;
    came[i].number = known_[j].number;
    known_[j] = came[i];
  }
  for (Known& piece : came) {
    if (piece.number != 0) continue;
    piece.number = free_number(piece);
    known_.push_back(piece);
  }
}

// Its label unless another piece of the same body has that number.
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
