#include "core/document/extract.h"

#include <algorithm>
#include <bit>

#include "core/base/assert.h"
#include "core/edit/separation.h"
#include "core/mesh/face_batches.h"
#include "core/mesh/measures.h"
#include "core/mesh/soup_topology.h"
#include "core/mesh/weld.h"
#include "core/world/mass_properties.h"

namespace kerf {

namespace {

// The vertices of some faces, ascending, as a bit set with constant-time rank (G. Jacobson: Space-efficient
// static trees and graphs, 1989).
class VertexSet {
 public:
  VertexSet(const Mesh& mesh, std::span<const FaceId> faces) : words_(mesh.vertex_slots() / 64 + 1) {
    for_each_corners(mesh, faces, [&](FaceId, const std::array<VertexId, 3>& corners) {
      for (const VertexId v : corners) words_[v.index / 64].bits |= uint64_t{1} << v.index % 64;
    });
    for (Word& word : words_) {
      word.before = count_;
      count_ += static_cast<uint32_t>(std::popcount(word.bits));
    }
  }

  uint32_t count() const { return count_; }
  // The number of vertices of the set less than v. Precondition: the set contains v.
  uint32_t rank(VertexId v) const {
    const Word& word = words_[v.index / 64];
    const uint64_t bit = uint64_t{1} << v.index % 64;
    KERF_ASSERT((word.bits & bit) != 0);
    return word.before + static_cast<uint32_t>(std::popcount(word.bits & (bit - 1)));
  }
  template <typename Visit>
  void for_each(Visit visit) const {
    for (uint32_t w = 0; w < words_.size(); ++w) {
      for (uint64_t bits = words_[w].bits; bits != 0; bits &= bits - 1)
        visit(VertexId(64 * w + static_cast<uint32_t>(std::countr_zero(bits))));
    }
  }

 private:
  struct Word {
    uint64_t bits = 0;
    uint32_t before = 0;  // vertices in the preceding words
  };
  std::vector<Word> words_;
  uint32_t count_ = 0;
};

Triangle triangle_of(const Extract& e, const std::array<uint32_t, 3>& t) {
  return {e.positions[t[0]], e.positions[t[1]], e.positions[t[2]]};
}

void measure(Extract& out) {
  double weight = 0;
  Vec3 sum{0};
  for (const auto& t : out.triangles) {
    const Triangle corners = triangle_of(out, t);
    const double area = triangle_area(corners);
    out.area += area;
    // Relative to the first vertex, so that a mesh far from the origin loses no precision.
    sum +=
        area / 3 *
        ((corners[0] - out.positions[0]) + (corners[1] - out.positions[0]) + (corners[2] - out.positions[0]));
    weight += area;
  }
  out.centroid = out.positions[0] + (weight > 0 ? sum / weight : Vec3(0));
  const SoupEdges edges = group_sides(out.triangles, out.positions.size());
  for (uint32_t e = 0; e < edges.count(); ++e) out.boundary_edges += edges.sides_of(e).size() == 1;
  if (out.boundary_edges > 0) return;
  const EnclosedVolume enclosed = enclosed_volume(out.positions, out.triangles, edges, out.centroid);
  if (enclosed.closed) out.volume = enclosed.volume;
}

MassProperties solid_of(const Extract& e, double density) {
  VolumeMoments moments;
  for (const auto& t : e.triangles) moments += volume_moments(triangle_of(e, t), e.centroid);
  return solid_mass(moments, e.centroid, density);
}

MassProperties shell_of(const Extract& e, const Sheet& sheet) {
  AreaMoments moments;
  for (const auto& t : e.triangles) {
    const Triangle corners = triangle_of(e, t);
    moments += area_moments(corners, triangle_area(corners), e.centroid);
  }
  return shell_mass(e.area, moments, e.centroid, sheet.thickness, sheet.density);
}

// Makes an extract of a solid body a solid if it encloses a volume.
void fill(Extract& out) {
  if (!out.volume || !(*out.volume > 0)) return;
  out.solid = true;
  out.centroid = solid_of(out, 1).centre;
}

}  // namespace

Extract extract_faces(const Body& body, std::span<const FaceId> faces) {
  Extract out;
  if (faces.empty()) return out;
  KERF_ASSERT(std::is_sorted(faces.begin(), faces.end()));
  const VertexSet vertices(body.mesh, faces);
  std::vector<Vec3> positions;
  positions.reserve(vertices.count());
  vertices.for_each([&](VertexId v) { positions.push_back(body.placement.to_world(body.mesh.position(v))); });
  const std::vector<uint32_t> first = weld_positions(positions);
  std::vector<uint32_t> number(positions.size());  // of the merged position
  for (uint32_t i = 0; i < positions.size(); ++i) {
    if (first[i] == i) out.positions.push_back(positions[i]);
    number[i] = first[i] == i ? static_cast<uint32_t>(out.positions.size() - 1) : number[first[i]];
  }
  const auto number_of = [&](VertexId v) { return number[vertices.rank(v)]; };
  if (!body.mesh.colours().blank()) {
    out.colours.reserve(out.positions.size());
    vertices.for_each([&](VertexId v) {
      if (number_of(v) == out.colours.size()) out.colours.push_back(body.mesh.colours().get(v));
    });
  }
  out.triangles.reserve(faces.size());
  for_each_corners(body.mesh, faces, [&](FaceId f, const std::array<VertexId, 3>& c) {
    out.triangles.push_back({number_of(c[0]), number_of(c[1]), number_of(c[2])});
    if (!body.material_names.empty()) out.materials.push_back(body.mesh.data(f).material);
  });
  measure(out);
  if (body.solid) fill(out);
  return out;
}

MassProperties mass_of(const Extract& extract, const Sheet& sheet) {
  return extract.solid ? solid_of(extract, sheet.density) : shell_of(extract, sheet);
}

std::vector<std::vector<FaceId>> faces_by_piece(const Body& body, bool every_component) {
  std::vector<std::vector<FaceId>> groups;
  std::vector<uint32_t> component;
  if (every_component) {
    groups.resize(label_components(body.mesh, component));
  } else {
    groups.resize(body.pieces.size());
  }
  for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
    if (!body.mesh.is_live(FaceId(f))) continue;
    groups[every_component ? component[f] : body.mesh.data(FaceId(f)).piece].push_back(FaceId(f));
  }
  std::erase_if(groups, [](const auto& group) { return group.empty(); });
  return groups;
}

}  // namespace kerf
