#include "core/mesh/build_mesh.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "core/base/union_find.h"
#include "core/mesh/kernel.h"
#include "core/mesh/orient.h"
#include "core/mesh/rings.h"
#include "core/mesh/soup_edges.h"
#include "core/mesh/weld.h"

namespace kerf {

namespace {

constexpr uint32_t kNone = 0xffffffffu;

bool is_finite(const Vec3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

class Builder {
 public:
  Builder(const Soup& soup, const Progress* progress) : soup_(soup), progress_(progress) {}

  Result<BuiltMesh> build() {
    assert(soup_.materials.empty() || soup_.materials.size() == soup_.triangles.size());
    report_.format = soup_.format;
    report_.faces_in_file = soup_.faces_in_file;
    report_.triangles_in_file = soup_.triangles_in_file;
    report_.warnings = soup_.warnings;
    report_.repairs.invalid_faces_dropped = soup_.invalid_faces_dropped;
    constexpr std::array kStages = {
        Stage{&Builder::weld, 0.07},          Stage{&Builder::keep_usable_triangles, 0.04},
        Stage{&Builder::group, 0.11},         Stage{&Builder::orient, 0.18},
        Stage{&Builder::find_partners, 0.09}, Stage{&Builder::name_vertices, 0.13},
        Stage{&Builder::measure, 0.06},       Stage{&Builder::fill_half_edges, 0.32}};
    Stages stages(progress_);
    for (const Stage& stage : kStages) {
      const Progress part = stages.next(stage.share);
      if (!part.report(0)) return cancelled();
      if (const Status done = (this->*stage.run)(part); !done) return done.error();
    }
    return BuiltMesh{std::move(mesh_), std::move(report_), soup_.material_names, parts()};
  }

 private:
  struct Stage {
    Status (Builder::*run)(const Progress&);
    double share;  // of the time
  };

  Status weld(const Progress& progress) {
    auto welded = weld_positions(soup_.positions, &progress);
    if (!welded) return welded.error();
    welded_ = std::move(*welded);
    return Done{};
  }

  Status keep_usable_triangles(const Progress& progress) {
    Pace pace(&progress, soup_.triangles.size());
    for (size_t t = 0; t < soup_.triangles.size(); ++t) {
      if (!pace.step()) return cancelled();
      if (!soup_.parts.empty()) kept_before_.push_back(static_cast<uint32_t>(triangles_.size()));
      const auto& [a, b, c] = soup_.triangles[t];
      assert(std::max({a, b, c}) < welded_.size());
      const Soup::Triangle w = {welded_[a], welded_[b], welded_[c]};
      if (!is_finite(soup_.positions[a]) || !is_finite(soup_.positions[b]) ||
          !is_finite(soup_.positions[c])) {
        ++report_.repairs.non_finite_faces_dropped;
      } else if (w[0] == w[1] || w[1] == w[2] || w[2] == w[0]) {
        ++report_.repairs.degenerate_faces_dropped;
      } else {
        triangles_.push_back(w);
        materials_.push_back(soup_.materials.empty() ? uint16_t{0} : soup_.materials[t]);
      }
    }
    if (!triangles_.empty()) return Done{};
    return bad_input("no face is left: every face is degenerate, not finite or invalid");
  }

  std::vector<MeshPart> parts() const {
    const auto face = [&](uint32_t triangle) {
      return triangle < kept_before_.size() ? kept_before_[triangle]
                                            : static_cast<uint32_t>(triangles_.size());
    };
    std::vector<MeshPart> parts;
    for (const MeshPart& part : soup_.parts) {
      const uint32_t first = face(part.first), last = face(part.last);
      if (first < last) parts.push_back({part.name, first, last});
    }
    return parts;
  }

  Status group(const Progress& progress) {
    auto edges = group_sides(triangles_, soup_.positions.size(), &progress);
    if (!edges) return edges.error();
    edges_ = std::move(*edges);
    return Done{};
  }

  Status orient(const Progress& progress) {
    Stages stages(&progress);
    const Progress agreeing = stages.next(0.6), facing = stages.next(0.4);
    const auto disagreeing = triangles_to_turn(triangles_, edges_, &agreeing);
    if (!disagreeing) return disagreeing.error();
    turn(*disagreeing);
    const auto inward = inward_triangles(soup_.positions, triangles_, edges_, &facing);
    if (!inward) return inward.error();
    turn(*inward);
    for (size_t t = 0; t < triangles_.size(); ++t)
      report_.repairs.reoriented_faces += (*disagreeing)[t] != (*inward)[t];
    return Done{};
  }

  void turn(const std::vector<bool>& chosen) {
    for (size_t t = 0; t < triangles_.size(); ++t) {
      if (!chosen[t]) continue;
      // Swapping the ends of side 0 turns the triangle and exchanges sides 1 and 2.
      std::swap(triangles_[t][0], triangles_[t][1]);
      const uint32_t s1 = static_cast<uint32_t>(3 * t + 1), s2 = s1 + 1;
      const uint32_t e1 = edges_.edge_of[s1], e2 = edges_.edge_of[s2];
      replace_side(e1, s1, s2);
      replace_side(e2, s2, s1);
      std::swap(edges_.edge_of[s1], edges_.edge_of[s2]);
    }
  }

  void replace_side(uint32_t edge, uint32_t old_side, uint32_t new_side) {
    const auto begin = edges_.sides.begin() + edges_.first[edge],
               end = edges_.sides.begin() + edges_.first[edge + 1];
    *std::lower_bound(begin, end, old_side, [](uint32_t s, uint32_t key) { return s / 3 < key / 3; }) =
        new_side;
  }

  uint32_t tail(uint32_t side) const { return triangles_[side / 3][side % 3]; }
  uint32_t head(uint32_t side) const { return triangles_[side / 3][(side % 3 + 1) % 3]; }
  static uint32_t next_side(uint32_t side) { return side % 3 == 2 ? side - 2 : side + 1; }
  static uint32_t previous_side(uint32_t side) { return side % 3 == 0 ? side + 2 : side - 1; }

  // Whether two triangles on one edge have the third corner in common too. They are linked as rings, so that
  // the edges that splitting makes inside them are linked as well.
  bool are_copies(uint32_t side, uint32_t other) const {
    return tail(previous_side(side)) == tail(previous_side(other));
  }

  // partner_[side] = the one other side of its edge, walked the other way; kNone at boundaries and in rings.
  Status find_partners(const Progress& progress) {
    partner_.assign(3 * triangles_.size(), kNone);
    Pace pace(&progress, edges_.count());
    for (uint32_t e = 0; e < edges_.count(); ++e) {
      if (!pace.step()) return cancelled();
      const auto sides = edges_.sides_of(e);
      report_.boundary_edges += sides.size() == 1;
      report_.non_manifold_edges += sides.size() > 2;
      if (sides.size() != 2 || tail(sides[0]) == tail(sides[1]) || are_copies(sides[0], sides[1])) continue;
      partner_[sides[0]] = sides[1];
      partner_[sides[1]] = sides[0];
    }
    report_.components = count_components(edges_);
    return Done{};
  }

  // Makes one vertex per fan of triangles around a position, in the order of the positions in the file. The
  // fan of side s is the one around its tail.
  Status name_vertices(const Progress& progress) {
    UnionFind fans(partner_.size());
    Pace pace(&progress, 3 * partner_.size());
    for (uint32_t s = 0; s < partner_.size(); ++s) {
      if (!pace.step()) return cancelled();
      if (partner_[s] != kNone) fans.unite(s, next_side(partner_[s]));
    }
    std::vector<uint32_t> fan_of_first(partner_.size(), kNone);
    std::vector<std::pair<uint32_t, uint32_t>> named;  // position, representative of the fan
    for (uint32_t s = 0; s < partner_.size(); ++s) {
      if (!pace.step()) return cancelled();
      if (fans.find(s) == s) named.emplace_back(tail(s), s);
    }
    std::sort(named.begin(), named.end());
    for (uint32_t v = 0; v < named.size(); ++v) {
      fan_of_first[named[v].second] = v;
      vertex_position_.push_back(named[v].first);
    }
    vertex_.resize(partner_.size());
    for (uint32_t s = 0; s < partner_.size(); ++s) {
      if (!pace.step()) return cancelled();
      vertex_[s] = fan_of_first[fans.find(s)];
      assert(vertex_[s] != kNone);
    }
    return Done{};
  }

  Status measure(const Progress& progress) {
    std::vector<bool> used(soup_.positions.size());
    for (const auto& t : triangles_) {
      for (const uint32_t v : t) used[v] = true;
    }
    size_t welded_in_use = 0, isolated = 0;
    for (size_t p = 0; p < soup_.positions.size(); ++p) {
      if (!used[welded_[p]])
        ++isolated;
      else if (welded_[p] != p)
        ++welded_in_use;
      else
        ++report_.vertices;
    }
    report_.faces = triangles_.size();
    report_.repairs.welded_vertices = welded_in_use;
    report_.repairs.isolated_vertices_dropped = isolated;
    report_.repairs.duplicated_vertices = vertex_position_.size() - report_.vertices;
    report_.min = report_.max = soup_.positions[triangles_[0][0]];
    Pace pace(&progress, triangles_.size());
    for (const auto& [a, b, c] : triangles_) {
      if (!pace.step()) return cancelled();
      const Triangle t = {soup_.positions[a], soup_.positions[b], soup_.positions[c]};
      const double area = triangle_area(t);
      report_.area += area;
      report_.repairs.zero_area_faces += area == 0;
      for (const Vec3& p : t) {
        report_.min = glm::min(report_.min, p);
        report_.max = glm::max(report_.max, p);
      }
    }
    return Done{};
  }

  Status fill_half_edges(const Progress& progress) {
    HalfEdges& m = mesh_.kernel().half_edges;
    const auto faces = static_cast<uint32_t>(triangles_.size());
    m.reserve(static_cast<uint32_t>(vertex_position_.size()), static_cast<uint32_t>(edges_.count()), faces);
    for (const uint32_t p : vertex_position_) m.add_vertex(soup_.positions[p]);
    Pace pace(&progress, 3 * partner_.size() + triangles_.size() + edges_.count());
    const bool filled =
        make_edges(m, pace) && make_faces(m, pace) && close_boundaries(m, pace) && link_rings(pace);
    if (!filled) return cancelled();
    return Done{};
  }

  // This and the following functions return false if building was stopped.
  bool make_edges(HalfEdges& m, Pace& pace) {
    half_edge_.resize(partner_.size());
    for (uint32_t s = 0; s < partner_.size(); ++s) {
      if (!pace.step()) return false;
      if (partner_[s] != kNone && partner_[s] < s) continue;
      half_edge_[s] = m.add_edge(vertex(s), vertex(next_side(s)));
      if (partner_[s] != kNone) half_edge_[partner_[s]] = opposite(half_edge_[s]);
    }
    return true;
  }

  bool make_faces(HalfEdges& m, Pace& pace) {
    auto& data = mesh_.kernel().faces;
    data.reserve(static_cast<uint32_t>(triangles_.size()));
    for (uint32_t t = 0; t < triangles_.size(); ++t) {
      if (!pace.step()) return false;
      const std::span sides(&half_edge_[3 * size_t{t}], 3);
      m.close(m.add_face(sides[0]), sides[0], sides[1], sides[2]);
      for (uint32_t i = 0; i < 3; ++i) m.set_outgoing(vertex(3 * t + i), sides[i]);
      data.push_back({.base = FaceId(t), .material = materials_[t]});
    }
    mesh_.kernel().live_faces = static_cast<uint32_t>(triangles_.size());
    return true;
  }

  // A vertex has one fan, so that at most one boundary half-edge starts there; it continues the boundary.
  bool close_boundaries(HalfEdges& m, Pace& pace) {
    std::vector<HalfEdgeId> starts(vertex_position_.size());
    for (uint32_t s = 0; s < partner_.size(); ++s) {
      if (!pace.step()) return false;
      if (partner_[s] != kNone) continue;
      const HalfEdgeId outer = opposite(half_edge_[s]);
      starts[m.from(outer).index] = outer;
    }
    for (uint32_t s = 0; s < partner_.size(); ++s) {
      if (!pace.step()) return false;
      if (partner_[s] != kNone) continue;
      const HalfEdgeId outer = opposite(half_edge_[s]);
      assert(starts[m.to(outer).index].valid());
      m.link(outer, starts[m.to(outer).index]);
    }
    return true;
  }

  bool link_rings(Pace& pace) {
    for (uint32_t e = 0; e < edges_.count(); ++e) {
      if (!pace.step()) return false;
      const auto sides = edges_.sides_of(e);
      if (sides.size() < 2 || partner_[sides[0]] != kNone) continue;
      std::vector<HalfEdgeId> members;
      for (const uint32_t s : sides) {
        const bool same_way = tail(s) == tail(sides[0]);
        members.push_back(same_way ? half_edge_[s] : opposite(half_edge_[s]));
      }
      link_ring(mesh_.kernel(), members);
    }
    return true;
  }

  VertexId vertex(uint32_t side) const { return VertexId(vertex_[side]); }

  const Soup& soup_;
  const Progress* progress_;
  std::vector<uint32_t> welded_;
  std::vector<Soup::Triangle> triangles_;  // corners are welded positions
  std::vector<uint16_t> materials_;
  std::vector<uint32_t>
      kept_before_;  // by triangle of the soup: the kept ones before it; empty without parts
  SoupEdges edges_;
  std::vector<uint32_t> partner_;          // one per side: the opposite side, or kNone
  std::vector<uint32_t> vertex_;           // one per side: the mesh vertex at its tail
  std::vector<uint32_t> vertex_position_;  // one per mesh vertex
  std::vector<HalfEdgeId> half_edge_;      // one per side
  Mesh mesh_;
  MeshReport report_;
};

}  // namespace

Result<BuiltMesh> build_mesh(const Soup& soup, const Progress* progress) {
  return Builder(soup, progress).build();
}

}  // namespace kerf
