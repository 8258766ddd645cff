#include "core/document/commands/add_mesh.h"

#include "core/world/load_body.h"

namespace kerf {

std::string AddMesh::words() const { return "Add " + name; }

void AddMesh::write(CommandWriter& line) const {
  line.mesh(file);
  line.text("name", name);
}

Result<AddMesh> AddMesh::read(const CommandReader& line) {
  const auto mesh = line.mesh();
  if (!mesh) return mesh.error();
  const auto name = line.text("name");
  if (!name) return name.error();
  return AddMesh{*mesh, *name};
}

Result<Delta> AddMesh::run(World& world, uint32_t generation, const Progress* progress) const {
  Result<Body> body = load_body(name, file, progress);
  if (!body) return body.error();
  Delta delta;
  delta.came = {world.add(std::move(*body), generation)};
  return delta;
}

}  // namespace kerf
