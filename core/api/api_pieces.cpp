#include <algorithm>
#include <memory>

#include "core/api/api_internal.h"
#include "core/base/parallel.h"
#include "core/document/extract.h"
#include "core/document/piece_looks.h"
#include "core/mesh/looks.h"
#include "core/world/world.h"

namespace kerf {

namespace {

void set_piece_mass(const Extract& e, const Body& body, kerf_mesh_info& info) {
  const MassProperties mass = mass_of(e, body.sheet);
  info.mass = mass.mass;
  const glm::dmat3& m = mass.inertia;
  const std::array<double, 6> inertia{m[0][0], m[1][1], m[2][2], m[0][1], m[0][2], m[1][2]};
  std::copy(inertia.begin(), inertia.end(), info.inertia);
}

}  // namespace

std::unique_ptr<kerf_mesh> mesh_of_piece(const Body& body, std::span<const FaceId> faces) {
  Extract e = extract_faces(body, faces);
  auto mesh = std::make_unique<kerf_mesh>();
  mesh->name = body.name_of(body.label(faces.front()));
  set_piece_mass(e, body, mesh->info);
  mesh->info.area = e.area;
  mesh->info.boundary_edges = e.boundary_edges;
  mesh->info.volume = e.volume.value_or(0);
  mesh->info.is_closed = e.volume.has_value();
  const Placement& placement = body.placement;
  for (int k = 0; k < 3; ++k) {
    mesh->info.centroid[k] = e.centroid[k];
    mesh->info.position[k] = placement.position[k];
  }
  const glm::dquat& q = placement.orientation;
  const std::array<double, 4> orientation{q.w, q.x, q.y, q.z};
  std::copy(orientation.begin(), orientation.end(), mesh->info.orientation);
  for (const FaceId f : faces)
    mesh->temperatures.push_back(
        body.heat.temperature(body.mesh, f, body.sheet.substance, body.sheet.thickness));
  mesh->positions = std::move(e.positions);
  mesh->triangles = std::move(e.triangles);
  mesh->colours = std::move(e.colours);
  mesh->materials = std::move(e.materials);
  mesh->material_names = body.material_names;
  if (body.looks) set_looks(*mesh, looks_of(body, faces, LookNormals::kSmooth), body.looks->surfaces());
  return mesh;
}

// Returns the pieces, largest area first.
Result<std::vector<std::unique_ptr<kerf_mesh>>> pieces_of(const World& world, const Progress& progress) {
  std::vector<std::pair<const Body*, std::vector<FaceId>>> parts;
  for (const BodyId id : world.ids()) {
    const Body& body = world.body(id);
    for (auto& faces : faces_by_piece(body, false)) parts.emplace_back(&body, std::move(faces));
  }
  std::vector<std::unique_ptr<kerf_mesh>> pieces(parts.size());
  if (!for_each_range(parts.size(), 1, &progress,
                      [&](size_t i, size_t) { pieces[i] = mesh_of_piece(*parts[i].first, parts[i].second); }))
    return cancelled();
  std::stable_sort(pieces.begin(), pieces.end(),
                   [](const auto& a, const auto& b) { return a->info.area > b->info.area; });
  return pieces;
}

}  // namespace kerf

kerf_result kerf_world_pieces(const kerf_world* world, const kerf_call_options* options, kerf_mesh*** out,
                              size_t* count) {
  if (out == nullptr || count == nullptr)
    return kerf::set_error(KERF_INVALID_ARGUMENT, "out and count: must not be null");
  return kerf::read_world(
      world, options, [&](const kerf::Document& document, const kerf::Progress& progress) -> kerf::Status {
        auto pieces = kerf::pieces_of(document.world(), progress);
        if (!pieces) return pieces.error();
        auto list = std::make_unique<kerf_mesh*[]>(pieces->size());
        for (size_t i = 0; i < pieces->size(); ++i) list[i] = (*pieces)[i].release();
        *count = pieces->size();
        *out = list.release();
        return kerf::Done{};
      });
}

void kerf_pieces_free(kerf_mesh** pieces, size_t count) {
  for (size_t i = 0; pieces != nullptr && i < count; ++i) delete pieces[i];
  delete[] pieces;
}
