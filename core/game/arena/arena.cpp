#include "core/game/arena/arena.h"

#include <algorithm>
#include <map>

#include "core/base/angle.h"
#include "core/world/load_body.h"

namespace kerf {

Placement Start::placement() const { return {position, turn_about({0, 1, 0}, heading)}; }

Result<Arena> load_arena(ArenaDescription description, const Progress* progress) {
  Arena arena{std::move(description), {}};
  std::map<std::filesystem::path, Body> loaded;
  Stages stages(progress);
  const double share = 1 / static_cast<double>(std::max<size_t>(arena.description.bodies.size(), 1));
  for (const ArenaBody& described : arena.description.bodies) {
    const Progress loading = stages.next(share);
    const std::filesystem::path mesh = described.body.mesh.lexically_normal();
    if (!loaded.contains(mesh)) {
      auto body = load_body(described.body.name, mesh, &loading);
      if (!body) return body.error();
      loaded.emplace(mesh, std::move(*body));
    }
    ModelBody& model = arena.bodies.emplace_back();
    model.body = loaded.at(mesh);
    model.body.name = described.body.name;
    model.body.placement = described.body.placement;
    model.body.sheet = described.body.sheet;
    model.body.pinned = !described.cuttable;
    model.body.motion.asleep = described.cuttable;
    if (const Status joined = add_joints(described.body.joints, model); !joined)
      return bad_input(mesh.string() + ": " + joined.error().message);
  }
  return arena;
}

}  // namespace kerf
