#include "core/world/connectivity.h"

#include "core/base/assert.h"

namespace kerf {

void LoadedComponents::join(uint32_t a, uint32_t b) {
  KERF_ASSERT(a != b && home[a] == home[b]);
  const auto [kept, dead] = std::minmax(a, b);
  joined.grow_to(dead + 1);
  joined.edit(dead) = kept + 1;
  FaceCounts& all = left.edit(kept);
  const FaceCounts& more = left[dead];
  all.faces += more.faces;
  all.area += more.area;
  left.edit(dead) = {};
}

Result<LoadedComponents> count_components(const Mesh& mesh, size_t components, const Progress* progress) {
  LoadedComponents table;
  if (components <= 1) return table;
  UnionFind connected(mesh.face_slots());
  std::vector<FaceId> neighbours;
  Pace pace(progress, 2 * size_t{mesh.face_slots()});
  for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
    if (!pace.step()) return cancelled();
    if (!mesh.is_live(FaceId(f))) continue;
    neighbours.clear();
    mesh.append_nearest_neighbours(FaceId(f), neighbours);
    for (const FaceId n : neighbours) connected.unite(f, n.index);
  }
  table.of_base.resize(mesh.face_slots());
  for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
    if (!pace.step()) return cancelled();
    if (!mesh.is_live(FaceId(f))) continue;
    const uint32_t first = connected.find(f);  // the lowest face: its number is already known
    if (first == f) {
      table.of_base[f] = table.left.size();
      table.left.push_back({});
      table.home.push_back(0);
    }
    FaceCounts& part = table.left.edit(table.of_base[f] = table.of_base[first]);
    ++part.faces;
    part.area += triangle_area(mesh.triangle(FaceId(f)));
  }
  return table;
}

}  // namespace kerf
