#include "core/document/commands/world_commands.h"

#include "core/document/text/fields.h"
#include "core/world/load_body.h"

namespace kerf {

void describe(Fields& f, AddMesh& c) {
  f.path("mesh", c.file);
  f.text("name", c.name);
}

Result<Delta> AddMesh::run(World& world, uint32_t generation, const Progress* progress) const {
  Result<Body> body = load_body(name, file, progress);
  if (!body) return body.error();
  Delta delta;
  delta.came = {world.add(std::move(*body), generation)};
  return delta;
}

void describe(Fields& f, SetEnvironment& c) {
  f.vector("gravity", c.around.gravity);
  f.number("ground", c.around.ground, kFinite);
  f.number("metre", c.around.metre, kPositive, 1);
}

Result<Delta> SetEnvironment::run(World& world, uint32_t, const Progress*) const {
  Delta delta;
  if (world.environment() == around) return delta;
  world.set_environment(around);
  delta.environment = true;
  return delta;
}

}  // namespace kerf
