#include "core/document/commands/add_mesh.h"

#include "core/document/text/fields.h"
#include "core/world/load_body.h"

namespace kerf {

std::string AddMesh::words() const { return "Add " + name; }

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

}  // namespace kerf
