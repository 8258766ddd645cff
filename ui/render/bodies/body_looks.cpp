#include "ui/render/bodies/body_looks.h"

#include "core/base/assert.h"
#include "ui/render/bodies/stage_marks.h"

namespace kerf {

BodyLooks::BodyLooks(BodyId id, const ViewOptions& options) {
  for (auto i = options.pieces.lower_bound({id, 0}); i != options.pieces.end() && i->first.body == id; ++i) {
    if (!(i->second == PieceLook{})) by_group_.emplace(i->first.label, i->second);
  }
  note_separation(id, options);
  const auto found = options.groups.find(id);
  if (found == options.groups.end()) return;
  KERF_ASSERT(found->second != nullptr);
  if (found->second->loose.empty()) return;
  groups_ = found->second;
  auto group = static_cast<uint32_t>(groups_->middles.size());
  for (const PieceGroups::Loose& loose : groups_->loose) {
    PieceLook look = of(loose.piece);
    look.offset = of(loose.goes_with).offset;
    look.turn = of(loose.goes_with).turn;
    if (look.number == 0) look.number = loose.piece;
    if (const auto set = came_off_.find(loose.piece); set != came_off_.end())
      came_off_.emplace(group, set->second);
    by_group_.emplace(group++, look);
  }
}

void BodyLooks::note_separation(BodyId id, const ViewOptions& options) {
  if (!options.stage) return;
  for (const PieceId& piece : options.stage->stayed) {
    if (piece.body == id) came_off_[piece.label] = false;
  }
  for (const PieceId& piece : options.stage->came_off) {
    if (piece.body == id) came_off_[piece.label] = true;
  }
}

const PieceLook& BodyLooks::of(uint32_t group) const {
  static const PieceLook plain;
  const auto found = by_group_.find(group);
  return found == by_group_.end() ? plain : found->second;
}

std::span<const uint32_t> labels_of(const std::shared_ptr<const PieceGroups>& groups) {
  return groups ? std::span(groups->of_face) : std::span<const uint32_t>();
}

}  // namespace kerf
