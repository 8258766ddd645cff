#include "core/cut/cuttable.h"

namespace kerf {

std::vector<BodyId> cuttable(const World& world) {
  std::vector<BodyId> ids = world.ids();
  std::erase_if(ids, [&](BodyId id) { return world.body(id).hidden; });
  return ids;
}

}  // namespace kerf
