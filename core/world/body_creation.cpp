#include "core/world/body_creation.h"

#include <algorithm>
#include <numeric>
#include <type_traits>

#include "core/base/assert.h"
#include "core/mesh/mesh.h"
#include "core/mesh/mesh_file.h"
#include "core/world/body_mass.h"
#include "core/world/remade_looks.h"

namespace kerf {

Result<Body> load_body(std::string name, const std::filesystem::path& file, const Progress* progress,
                       FileUnit unit) {
  ProgressShares shares(progress);
  const Progress loading = shares.next(0.5), making = shares.next(0.5);
  auto built = load_mesh(file, &loading, {unit});
  if (!built) return built.error();
  return make_body(std::move(name), std::move(*built), &making);
}

namespace {

void sort_by_loaded_face(Remeshed& r, const PieceCopy& copy) {
  KERF_ASSERT(r.origins.size() == r.triangles.size() && copy.loaded.size() == copy.faces.size());
  std::vector<uint32_t> order(r.triangles.size());
  std::iota(order.begin(), order.end(), uint32_t{0});
  const auto loaded = [&](uint32_t t) { return copy.loaded[r.origins[t].index]; };
  std::stable_sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) { return loaded(a) < loaded(b); });
  const auto sort = [&](auto& items) {
    std::decay_t<decltype(items)> sorted;
    for (const uint32_t t : order) sorted.push_back(items[t]);
    items = std::move(sorted);
  };
  sort(r.triangles);
  sort(r.origins);
  for (std::vector<FaceUvs>& set : r.uv_sets) sort(set);
}

// Converts parts of loaded faces to parts of the triangles, which are sorted by loaded face.
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

void label_faces(Body& made, const Body& body, const PieceCopy& copy, const Remeshed& r) {
  Piece whole = made.pieces[0];
  LoadedComponents components;
  if (!copy.components.empty()) {
    components.home = body.components.home;
    components.joined = body.components.joined;
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

double area_of(const Body& body, size_t face) {
  return triangle_area(body.mesh.triangle(FaceId(static_cast<uint32_t>(face))));
}

void add_energy(Body& made, size_t face, double joules) {
  const FaceId f(static_cast<uint32_t>(face));
  if (joules != 0) made.heat.set_energy(made.mesh, f, made.heat.energy_of(made.mesh, f) + joules);
}

// Shares the energy of each face by area with its triangles, which keep its highest temperature.
void share_heat(Body& made, const Body& body, const PieceCopy& copy, const Remeshed& r) {
  std::vector<bool> left(copy.faces.size(), false);
  for (size_t first = 0, last = 0; first < r.origins.size(); first = last) {
    const FaceId origin = r.origins[first];
    left[origin.index] = true;
    double all = 0;
    for (last = first; last < r.origins.size() && r.origins[last] == origin; ++last)
      all += area_of(made, last);
    const double energy = body.heat.energy_of(copy.mesh, origin);
    const double hottest = body.heat.hottest_of(copy.mesh, origin);
    for (size_t t = first; t < last; ++t) {
      add_energy(made, t,
                 all > 0 ? energy * (area_of(made, t) / all) : energy / static_cast<double>(last - first));
      if (hottest > kAmbient) made.heat.record_hottest(made.mesh, FaceId(static_cast<uint32_t>(t)), hottest);
    }
  }
  for (uint32_t f = 0; f < left.size(); ++f) {
    if (!left[f]) add_energy(made, 0, body.heat.energy_of(copy.mesh, FaceId(f)));
  }
}

// Heat of followed faces that lies on a triangle.
struct Covered {
  double joules = 0;
  double area = 0;  // of the quarters that lie on it (m^2)
  double rise = 0;  // highest temperatures above the ambient, integrated over this area (K m^2)
};

// Gives each triangle the energy of the quarters that lie on it. Its highest temperature becomes the mean of
// theirs over its area, with the ambient between them: a large triangle over a small hot spot was not hot.
void collect_heat(Body& made, const Body& body, const PieceCopy& copy, const Remeshed& r) {
  std::vector<Covered> covered(copy.faces.size());  // by the face from which the triangle stems
  for (const FollowedFace& followed : r.followed) {
    const double area = 0.25 * triangle_area(copy.mesh.triangle(followed.face));
    for (const FaceId on : followed.quarters) {
      Covered& all = covered[on.index];
      all.joules += 0.25 * body.heat.energy_of(copy.mesh, followed.face);
      all.area += area;
      all.rise += area * (body.heat.hottest_of(copy.mesh, followed.face) - kAmbient);
    }
  }
  for (size_t t = 0; t < r.origins.size(); ++t) {
    const Covered all = std::exchange(covered[r.origins[t].index], {});
    const double area = std::max(all.area, area_of(made, t));
    add_energy(made, t, all.joules);
    if (all.rise > 0)
      made.heat.record_hottest(made.mesh, FaceId(static_cast<uint32_t>(t)), kAmbient + all.rise / area);
  }
  for (const Covered& all : covered) add_energy(made, 0, all.joules);
}

void hand_down_heat(Body& made, const Body& body, const PieceCopy& copy, const Remeshed& r) {
  if (copy.mesh.columns().blank()) return;
  if (r.followed.empty()) {
    share_heat(made, body, copy, r);
  } else {
    collect_heat(made, body, copy, r);
  }
}

}  // namespace

PieceCopy copy_piece(const Body& body, uint32_t label) {
  KERF_ASSERT(label < body.pieces.size() && body.pieces[label].faces > 0);
  PieceCopy copy;
  copy.label = label;
  copy.faces = body.faces_of(label);
  copy.mesh = extract_mesh(body.mesh, copy.faces);
  for (const FaceId f : copy.faces) {
    const FaceId base = body.loaded_base(f);
    copy.loaded.push_back(body.loaded_face(base).index);
    if (!body.components.left.empty()) copy.components.push_back(body.components.of(base));
  }
  return copy;
}

Result<Body> rebuilt_body(const Body& body, const PieceCopy& copy, Remeshed& remeshed,
                          std::span<const MeshPart> parts, const Progress* progress) {
  KERF_ASSERT(!remeshed.triangles.empty());
  ProgressShares shares(progress);
  const Progress building = shares.next(0.5), making = shares.next(0.5);
  sort_by_loaded_face(remeshed, copy);
  auto built = build_remeshed(remeshed, copy.mesh, &building);
  if (!built) return built.error();
  built->report.format = body.loaded.format;
  built->material_names = body.material_names;
  built->parts = parts_of(remeshed, copy, parts);
  auto made = make_body(body.name, std::move(*built), &making);
  if (!made) return made.error();
  made->named = body.named;
  made->piece_names = body.piece_names;
  made->placement = body.placement;
  made->hidden = body.hidden;
  made->motion = body.motion;
  made->sheet = body.sheet;
  made->pinned = body.pinned;
  made->solid = body.solid;
  made->cut_material = body.cut_material;
  made->looks = remade_looks(body, copy, remeshed);
  label_faces(*made, body, copy, remeshed);
  hand_down_heat(*made, body, copy, remeshed);
  if (made->solid) update_mass_properties(*made);
  return made;
}

}  // namespace kerf
