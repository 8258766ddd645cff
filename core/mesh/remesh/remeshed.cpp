#include "core/mesh/remesh/remeshed.h"

#include <algorithm>
#include <cmath>

#include "core/base/assert.h"
#include "core/mesh/measures.h"
#include "core/mesh/orientation.h"
#include "core/mesh/pair_sides.h"
#include "core/mesh/remesh/collapser_internal.h"
#include "core/mesh/weld.h"

namespace kerf {

std::vector<uint16_t> materials_of(const Remeshed& remeshed, const Mesh& mesh) {
  std::vector<uint16_t> materials;
  materials.reserve(remeshed.origins.size());
  for (const FaceId f : remeshed.origins) materials.push_back(mesh.data(f).material);
  return materials;
}

namespace {

// Returns the barycentric weights of a point of a triangle; 1 for the first corner if it has no area.
std::array<double, 3> corner_weights(const Vec3& p, const Triangle& t) {
  const double a = triangle_area({p, t[1], t[2]}), b = triangle_area({p, t[2], t[0]}),
               c = triangle_area({p, t[0], t[1]});
  const double sum = a + b + c;
  if (!(sum > 0)) return {1, 0, 0};
  return {a / sum, b / sum, c / sum};
}

VertexColour colour_at(const Vec3& p, const Mesh& mesh, FaceId f) {
  const Triangle t = mesh.triangle(f);
  const std::array<VertexId, 3> v = mesh.corners(f);
  const VertexColours& of = mesh.colours();
  return mix({of.get(v[0]), of.get(v[1]), of.get(v[2])}, corner_weights(nearest_point(p, t), t));
}

// Sets the colours of the positions at which the mesh has a vertex. Returns which positions these are.
std::vector<bool> copy_vertex_colours(const Remeshed& remeshed, const Mesh& mesh,
                                      std::vector<VertexColour>& colours) {
  std::vector<Vec3> positions = remeshed.positions;
  std::vector<VertexId> vertices;
  std::vector<bool> listed(mesh.vertex_slots());
  for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
    if (!mesh.is_live(FaceId(f))) continue;
    for (const VertexId v : mesh.corners(FaceId(f))) {
      if (listed[v.index]) continue;
      listed[v.index] = true;
      vertices.push_back(v);
      positions.push_back(mesh.position(v));
    }
  }
  const std::vector<uint32_t> first = weld_positions(positions);
  std::vector<bool> known(colours.size());
  for (size_t i = 0; i < vertices.size(); ++i) {
    const uint32_t p = first[colours.size() + i];
    if (p >= colours.size() || known[p]) continue;
    known[p] = true;
    colours[p] = mesh.colours().get(vertices[i]);
  }
  return known;
}

// Copies the faces over welded positions; drops degenerate ones, which a cut may leave.
Remeshed copy_faces(const Mesh& mesh) {
  std::vector<Vec3> positions(mesh.vertex_slots(), Vec3(0));
  for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
    if (!mesh.is_live(FaceId(f))) continue;
    for (const VertexId v : mesh.corners(FaceId(f))) positions[v.index] = mesh.position(v);
  }
  const std::vector<uint32_t> first = weld_positions(positions);
  std::vector<uint32_t> number(positions.size(), FaceId::kNone);
  Remeshed copy;
  for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
    if (!mesh.is_live(FaceId(f))) continue;
    std::array<uint32_t, 3> at{};
    for (size_t i = 0; i < 3; ++i) at[i] = first[mesh.corners(FaceId(f))[i].index];
    if (at[0] == at[1] || at[1] == at[2] || at[2] == at[0]) continue;
    for (uint32_t& corner : at) {
      if (number[corner] == FaceId::kNone) {
        number[corner] = static_cast<uint32_t>(copy.positions.size());
        copy.positions.push_back(positions[corner]);
      }
      corner = number[corner];
    }
    copy.triangles.push_back(at);
    copy.origins.push_back(FaceId(f));
  }
  return copy;
}

// The squared cosines of 15, 30, 60 and 90 degrees, by which one collapse may turn a face.
constexpr std::array kMinCosine2 = {0.93301270189221932, 0.75, 0.25, 0.0};
// Down to this multiple of the target number of faces only the quadrics are used.
constexpr size_t kFacesForSamples = 5;
// The first bound of the distance of samples, relative to the edge of an equilateral face of the target size;
// later ones double.
constexpr double kFirstBound = 1 / 2048.0;
constexpr double kLastBound = 1;
constexpr size_t kFirstTurns = 2;  // maximum turns of the first bounded rounds

// Returns the edge of an equilateral triangle of this area.
double edge_of(double area) { return std::sqrt(4 / std::sqrt(3.0) * area); }

// Returns false if stopped.
bool collapse_to_error(Collapser& collapser, double error) {
  collapser.bound_distance(kShareForSamples * error);
  return collapser.run_round({.faces = 0, .min_cosine2 = kMinCosine2.front()});
}

// Returns false if stopped.
bool collapse_to_faces(Collapser& collapser, size_t faces) {
  const auto round = [&](size_t until, double cosine2) {
    return collapser.left() <= until || collapser.run_round({.faces = until, .min_cosine2 = cosine2});
  };
  if (!round(kFacesForSamples * faces, kMinCosine2.front())) return false;
  const double edge = edge_of(collapser.area() / static_cast<double>(faces));
  for (const auto turns :
       {std::span(kMinCosine2).first(kFirstTurns), std::span(kMinCosine2).subspan(kFirstTurns)}) {
    for (double bound = kFirstBound; bound <= kLastBound && collapser.left() > faces; bound *= 2) {
      collapser.bound_distance(bound * edge);
      for (const double cosine2 : turns) {
        if (!round(faces, cosine2)) return false;
      }
    }
  }
  collapser.bound_distance(std::nullopt);
  return std::all_of(kMinCosine2.begin(), kMinCosine2.end(),
                     [&](double cosine2) { return round(faces, cosine2); });
}

// Returns the remaining faces, with welded positions in the order of their first use.
Remeshed to_remeshed(const Mesh& mesh, const FlatSheets& sheets, const Collapser& collapser) {
  const FlatSurface& surface = collapser.surface();
  std::vector<uint32_t> number(surface.vertices(), kNoIndex);
  std::vector<Vec3> positions;
  for (uint32_t f = 0; f < surface.faces(); ++f) {
    if (!surface.has(f)) continue;
    for (const uint32_t v : surface.corners(f)) {
      if (number[v] != kNoIndex) continue;
      number[v] = static_cast<uint32_t>(positions.size());
      positions.push_back(mesh.position(sheets.vertices[v]));
    }
  }
  WeldedTriangles welded(positions);
  Remeshed out;
  out.uv_sets.resize(sheets.uv_sets.size());
  for (uint32_t f = 0; f < surface.faces(); ++f) {
    if (!surface.has(f)) continue;
    const auto& [a, b, c] = surface.corners(f);
    if (!welded.add({number[a], number[b], number[c]})) continue;
    out.origins.push_back(sheets.faces[f]);
    for (size_t set = 0; set < out.uv_sets.size(); ++set) out.uv_sets[set].push_back(collapser.uvs(set, f));
  }
  out.positions = std::move(welded.positions);
  out.triangles = std::move(welded.triangles);
  KERF_ASSERT(out.origins.size() == out.triangles.size());
  return out;
}

}  // namespace

std::vector<VertexColour> colours_of(const Remeshed& remeshed, const Mesh& mesh) {
  std::vector<VertexColour> colours;
  if (mesh.colours().blank()) return colours;
  KERF_ASSERT(remeshed.origins.size() == remeshed.triangles.size());
  colours.resize(remeshed.positions.size());
  std::vector<bool> known = copy_vertex_colours(remeshed, mesh, colours);
  for (size_t t = 0; t < remeshed.triangles.size(); ++t) {
    for (const uint32_t p : remeshed.triangles[t]) {
      if (known[p]) continue;
      known[p] = true;
      colours[p] = colour_at(remeshed.positions[p], mesh, remeshed.origins[t]);
    }
  }
  return colours;
}

Result<BuiltMesh> build_remeshed(const Remeshed& remeshed, const Mesh& mesh, const Progress* progress) {
  Soup soup;
  soup.positions = remeshed.positions;
  soup.colours = colours_of(remeshed, mesh);
  soup.triangles = remeshed.triangles;
  soup.materials = materials_of(remeshed, mesh);
  soup.faces_in_file = soup.triangles_in_file = soup.triangles.size();
  return build_mesh(soup, progress);
}

Result<Remeshed> turn_shells(const Mesh& mesh, const Progress* progress) {
  Remeshed turned = copy_faces(mesh);
  const SoupEdges edges = group_sides(turned.triangles, turned.positions.size());
  auto patches = find_patches(turned.triangles, edges, progress);
  if (!patches) return patches.error();
  join_patches_of_shells(turned.positions, turned.triangles, edges, *patches);
  for (const uint32_t p : overlapping_patches(turned.positions, turned.triangles, *patches)) {
    for (const uint32_t t : patches->triangles_of(p))
      std::swap(turned.triangles[t][0], turned.triangles[t][1]);
  }
  return turned;
}

Result<Remeshed> simplify(const Mesh& mesh, const SimplifyTarget& target, const RemeshLimits& limits,
                          const Progress* progress, std::span<const FaceId> followed) {
  KERF_ASSERT(mesh.live_faces() > 0);
  ProgressShares shares(progress);
  const Progress copying = shares.next(0.3), collapsing = shares.next(0.6), back = shares.next(0.1);
  const auto sheets = to_flat_sheets(mesh, limits, &copying);
  if (!sheets) return sheets.error();
  Collapser collapser(mesh, *sheets, target.faces, followed, &collapsing);
  const bool done = std::isfinite(target.error)
                        ? collapse_to_error(collapser, target.error * sheets->frame.scale)
                        : collapse_to_faces(collapser, target.faces);
  if (!done || !back.report(0)) return cancelled();
  Remeshed out = to_remeshed(mesh, *sheets, collapser);
  out.followed = collapser.followed();
  return out;
}

}  // namespace kerf
