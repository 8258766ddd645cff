#include "ui/render/view/spread.h"

#include "core/base/assert.h"

namespace kerf {

namespace {

const PieceGroups& groups_of(const World& world, BodyId id, ViewOptions& look) {
  std::shared_ptr<const PieceGroups>& groups = look.groups[id];
  if (!groups) groups = std::make_shared<const PieceGroups>(group_pieces(world.body(id)));
  return *groups;
}

}  // namespace

void spread_pieces(const World& world, double spread, ViewOptions& look) {
  look.groups.clear();
  spread_further(world, spread, look);
}

void spread_further(const World& world, double spread, ViewOptions& look) {
  KERF_ASSERT(spread >= 0);
  for (auto& [id, piece] : look.pieces) piece.offset = Vec3(0);
  if (spread > 0) {
    const World::Bounds bounds = world.bounds();
    const Vec3 middle = 0.5 * (bounds.min + bounds.max);
    for (const BodyId id : world.ids()) {
      const Body& body = world.body(id);
      const PieceGroups& groups = groups_of(world, id, look);
      KERF_ASSERT(groups.middles.size() == body.pieces.size());
      for (uint32_t label = 0; label < body.pieces.size(); ++label) {
        if (body.pieces[label].faces == 0) continue;
        look.pieces[{id, label}].offset = spread * (body.placement.to_world(groups.middles[label]) - middle);
      }
    }
  } else {
    look.groups.clear();
  }
  std::erase_if(look.pieces, [](const auto& entry) { return entry.second == PieceLook(); });
}

}  // namespace kerf
