#include "ui/render/body_looks.h"

namespace kerf {

BodyLooks::BodyLooks(BodyId id, const ViewOptions& options) {
  for (auto i = options.pieces.lower_bound({id, 0}); i != options.pieces.end() && i->first.body == id; ++i) {
    if (!(i->second == PieceLook{})) by_group_.emplace(i->first.label, i->second);
  }
  const auto found = options.groups.find(id);
  if (found == options.groups.end() || found->second->loose.empty()) return;
  groups_ = found->second;
  auto group = static_cast<uint32_t>(groups_->middles.size());
  for (const PieceGroups::Loose& loose : groups_->loose) {
    PieceLook look = of(loose.piece);
    look.offset = of(loose.goes_with).offset;
    look.turn = of(loose.goes_with).turn;
    if (look.number == 0) look.number = loose.piece;
    by_group_.emplace(group++, look);
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
