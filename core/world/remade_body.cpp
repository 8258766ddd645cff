#include "core/world/remade_body.h"

#include <algorithm>
#include <cassert>
#include <numeric>

#include "core/mesh/extract_mesh.h"

namespace kerf {

namespace {

void sort_by_loaded_face(Remeshed& r, const PieceCopy& copy) {
  std::vector<uint32_t> order(r.triangles.size());
  std::iota(order.begin(), order.end(), uint32_t{0});
  const auto loaded = [&](uint32_t t) { return copy.loaded[r.origins[t].index]; };
  std::stable_sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) { return loaded(a) < loaded(b); });
  Remeshed sorted;
  for (const uint32_t t : order) {
    sorted.triangles.push_back(r.triangles[t]);
    sorted.origins.push_back(r.origins[t]);
  }
  r.triangles = std::move(sorted.triangles);
  r.origins = std::move(sorted.origins);
}

// Parts of loaded faces as parts of the triangles, which are in the order of these.
std::vector<MeshPart> parts_of(const Remeshed& r, const PieceCopy& copy, std::span<const MeshPart> parts) {
  std::vector<uint32_t> loaded;
  for (const FaceId origin : r.origins) loaded.push_back(copy.loaded[origin.index]);
  const auto first_from = [&](uint32_t face) {
    return static_cast<uint32_t>(std::lower_bound(loaded.begin(), loaded.end(), face) - loaded.begin());
  };
  std::vector<MeshPart> own;
  for (const MeshPart& part : parts) {
    const uint32_t first = first_from(part.first), last = first_from(part.last);
    if (first < last) own.push_back({part.name, first, last});
  }
  return own;
}

// Gives the piece its label, and counts it and its components.
void label_faces(Body& made, const Body& body, const PieceCopy& copy, const Remeshed& r) {
  Piece whole = made.pieces[0];
  LoadedComponents components;
  if (!copy.components.empty()) {
    components.home = body.components.home;
    for (uint32_t c = 0; c < components.home.size(); ++c) components.left.push_back({});
    for (const FaceId origin : r.origins) components.of_base.push_back(copy.components[origin.index]);
  }
  for (uint32_t f = 0; f < r.triangles.size(); ++f) {
    made.mesh.edit_data(FaceId(f)).piece = copy.label;
    const uint32_t component = components.at_home(FaceId(f), copy.label);
    if (component == LoadedComponents::kNone && copy.label == 0) continue;
    FaceCounts& part = component != LoadedComponents::kNone ? components.left.edit(component) : whole.cut_off;
    ++part.faces;
    part.area += triangle_area(made.mesh.triangle(FaceId(f)));
  }
  made.components = std::move(components);
  made.pieces = {};
  for (uint32_t p = 0; p < body.pieces.size(); ++p) made.pieces.push_back(p == copy.label ? whole : Piece{});
}

// The triangles that stem from one face share its energy by area.
void hand_down_heat(Body& made, const Body& body, const PieceCopy& copy, const Remeshed& r) {
  if (copy.mesh.columns().blank()) return;
  std::vector<double> joules;
  for (uint32_t f = 0; f < copy.faces.size(); ++f)
    joules.push_back(body.heat.energy_of(copy.mesh, FaceId(f)));
  for (const auto& [gone, heir] : r.merged) joules[heir.index] += std::exchange(joules[gone.index], 0);
  const auto area = [&](size_t t) {
    return triangle_area(made.mesh.triangle(FaceId(static_cast<uint32_t>(t))));
  };
  const auto add = [&](size_t t, double energy) {
    const FaceId f(static_cast<uint32_t>(t));
    if (energy != 0) made.heat.set_energy(made.mesh, f, made.heat.energy_of(made.mesh, f) + energy);
  };
  for (size_t first = 0, last = 0; first < r.origins.size(); first = last) {
    const FaceId origin = r.origins[first];
    double all = 0;
    for (last = first; last < r.origins.size() && r.origins[last] == origin; ++last) all += area(last);
    const double energy = std::exchange(joules[origin.index], 0);
    for (size_t t = first; t < last; ++t) {
      add(t, all > 0 ? energy * (area(t) / all) : energy / static_cast<double>(last - first));
      const double hottest = body.heat.hottest_of(copy.mesh, origin);
      if (hottest > kAmbient) made.heat.note_hottest(made.mesh, FaceId(static_cast<uint32_t>(t)), hottest);
    }
  }
  // Of faces of which nothing is left.
  add(0, std::accumulate(joules.begin(), joules.end(), 0.0));
}

}  // namespace

PieceCopy copy_piece(const Body& body, uint32_t label) {
  PieceCopy copy;
  copy.label = label;
  for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
    const FaceId face(f);
    if (body.mesh.is_live(face) && body.mesh.data(face).piece == label) copy.faces.push_back(face);
  }
  copy.mesh = extract_mesh(body.mesh, copy.faces);
  for (const FaceId f : copy.faces) {
    const FaceId base = body.mesh.data(f).base;
    copy.loaded.push_back(body.loaded_face(base).index);
    if (!body.components.left.empty()) copy.components.push_back(body.components.of_base[base.index]);
  }
  return copy;
}

Result<Body> remade_body(const Body& body, const PieceCopy& copy, Remeshed& remeshed,
                         std::span<const MeshPart> parts, const Progress* progress) {
  assert(!remeshed.triangles.empty());
  Stages stages(progress);
  const Progress building = stages.next(0.5), making = stages.next(0.5);
  sort_by_loaded_face(remeshed, copy);
  auto built = build_remeshed(remeshed, copy.mesh, &building);
  if (!built) return built.error();
  built->report.format = body.loaded.format;
  built->material_names = body.material_names;
  built->parts = parts_of(remeshed, copy, parts);
  auto made = make_body(body.name, std::move(*built), &making);
  if (!made) return made.error();
  made->named = body.named;
  made->placement = body.placement;
  made->hidden = body.hidden;
  made->motion = body.motion;
  made->sheet = body.sheet;
  made->pinned = body.pinned;
  label_faces(*made, body, copy, remeshed);
  hand_down_heat(*made, body, copy, remeshed);
  return made;
}

}  // namespace kerf
