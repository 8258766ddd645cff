#include "core/mesh/build_mesh.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <utility>

#include "core/base/assert.h"
#include "core/base/number_format.h"
#include "core/base/parallel.h"
#include "core/mesh/half_edges_internal.h"
#include "core/mesh/looks.h"
#include "core/mesh/orientation.h"
#include "core/mesh/pair_sides.h"
#include "core/mesh/soup_topology.h"
#include "core/mesh/weld.h"

namespace kerf {

namespace {

constexpr size_t kItems = 1 << 16;   // triangles, edges or vertices per range
constexpr double kMaxWidth = 1e150;  // m; squared lengths are finite

class Builder {
 public:
  Builder(const Soup& soup, const Progress* progress) : soup_(soup), progress_(progress) {}

  Result<BuiltMesh> build() {
    KERF_ASSERT(soup_.materials.empty() || soup_.materials.size() == soup_.triangles.size());
    KERF_ASSERT(soup_.colours.empty() || soup_.colours.size() == soup_.positions.size());
    report_.format = soup_.format;
    report_.faces_in_file = soup_.faces_in_file;
    report_.triangles_in_file = soup_.triangles_in_file;
    report_.warnings = soup_.warnings;
    report_.repairs.invalid_faces_dropped = soup_.invalid_faces_dropped;
    report_.repairs.incomplete_faces_dropped = soup_.incomplete_faces_dropped;
    constexpr std::array kStages = {
        Stage{&Builder::weld, 0.13},          Stage{&Builder::select_triangles, 0.08},
        Stage{&Builder::group, 0.17},         Stage{&Builder::orient, 0.23},
        Stage{&Builder::find_partners, 0.08}, Stage{&Builder::find_vertices, 0.13},
        Stage{&Builder::fill_mesh, 0.13},     Stage{&Builder::measure, 0.05}};
    ProgressShares shares(progress_);
    for (const Stage& stage : kStages) {
      const Progress part = shares.next(stage.share);
      if (!part.report(0)) return cancelled();
      if (const Status done = (this->*stage.run)(part); !done) return done.error();
    }
    auto looks = Looks::make(soup_, sources_, turned_, report_.warnings);
    return BuiltMesh{std::move(mesh_), std::move(report_), soup_.material_names, std::move(parts_),
                     std::move(looks)};
  }

 private:
  struct Stage {
    Status (Builder::*run)(const Progress&);
    double share;  // of the time
  };

  Status weld(const Progress& progress) {
    return unpack(weld_positions(soup_.positions, &progress), welded_);
  }

  Status select_triangles(const Progress& progress) {
    auto usable = usable_triangles(soup_, welded_, &progress);
    if (!usable) return usable.error();
    report_.repairs.degenerate_faces_dropped = usable->degenerate;
    report_.repairs.non_finite_faces_dropped = usable->non_finite;
    triangles_ = std::move(usable->triangles);
    materials_ = std::move(usable->materials);
    parts_ = std::move(usable->parts);
    sources_ = std::move(usable->sources);
    constexpr size_t kMax = std::numeric_limits<uint32_t>::max() / 6;  // of half-edges, two per side
    if (triangles_.size() > kMax) return bad_input("the mesh has more than 715 827 882 faces");
    if (!triangles_.empty()) return Done{};
    return bad_input("no face is usable: every face is degenerate, not finite or invalid");
  }

  Status group(const Progress& progress) {
    return unpack(group_sides(triangles_, soup_.positions.size(), &progress), edges_);
  }

  Status orient(const Progress& progress) {
    ProgressShares shares(&progress);
    const Progress agreeing = shares.next(0.2), finding = shares.next(0.8);
    const auto disagreeing = triangles_to_turn(triangles_, edges_, &agreeing);
    if (!disagreeing) return disagreeing.error();
    turn(*disagreeing);
    auto patches = find_patches(triangles_, edges_, &finding);
    if (!patches) return patches.error();
    report_.components = count_components(*patches, edges_);
    join_patches_of_shells(soup_.positions, triangles_, edges_, *patches);
    const std::vector<bool> inward = inward_triangles(soup_.positions, triangles_, *patches);
    turn(inward);
    record_overlaps(overlapping_patches(soup_.positions, triangles_, *patches).size());
    patch_of_ = std::move(patches->patch_of);
    turned_.resize(triangles_.size());
    for (size_t t = 0; t < triangles_.size(); ++t) {
      turned_[t] = (*disagreeing)[t] != inward[t];
      report_.repairs.reoriented_faces += turned_[t];
    }
    return Done{};
  }

  void record_overlaps(size_t shells) {
    if (shells == 0) return;
    report_.overlap_warning =
        grouped(shells) +
        (shells == 1
             ? " closed part is inside another one and faces the same way: its volume counts twice unless "
               "it is turned"
             : " closed parts are inside others and face the same way: their volumes count twice unless they "
               "are turned") +
        " (--turn-shells, or Turn Inner Shells in the editor).";
    report_.warnings.push_back(report_.overlap_warning);
  }

  void turn(const std::vector<bool>& selected) {
    KERF_ASSERT(selected.size() == triangles_.size());
    if (std::find(selected.begin(), selected.end(), true) == selected.end()) return;
    std::vector<uint32_t> edge_of = edges_of_sides(edges_);
    for (size_t t = 0; t < triangles_.size(); ++t) {
      if (!selected[t]) continue;
      // Swapping the ends of side 0 reverses the triangle and exchanges sides 1 and 2.
      std::swap(triangles_[t][0], triangles_[t][1]);
      const uint32_t s1 = static_cast<uint32_t>(3 * t + 1), s2 = s1 + 1;
      replace_side(edge_of[s1], s1, s2);
      replace_side(edge_of[s2], s2, s1);
    }
  }

  void replace_side(uint32_t edge, uint32_t old_side, uint32_t new_side) {
    const auto begin = edges_.sides.begin() + edges_.first[edge],
               end = edges_.sides.begin() + edges_.first[edge + 1];
    *std::lower_bound(begin, end, old_side, [](uint32_t s, uint32_t key) { return s / 3 < key / 3; }) =
        new_side;
  }

  // The start of a side: a position until find_vertices(), then a vertex.
  uint32_t tail(uint32_t side) const { return triangles_[side / 3][side % 3]; }
  static uint32_t previous_side(uint32_t side) { return side % 3 == 0 ? side + 2 : side - 1; }

  // Sets partner_[side] to the opposite side of its edge, or to kNoSide at boundaries and in rings.
  Status find_partners(const Progress& progress) {
    struct Found {
      size_t boundary = 0;
      std::vector<uint32_t> rings, non_manifold;
    };
    std::vector<Found> found(range_count(edges_.count(), kItems));
    partner_.assign(3 * triangles_.size(), kNoSide);
    const auto pair = [&](size_t first, size_t end) {
      Found& here = found[first / kItems];
      for (auto e = static_cast<uint32_t>(first); e < end; ++e) {
        const auto sides = edges_.sides_of(e);
        here.boundary += sides.size() == 1;
        if (sides.size() > 2) here.non_manifold.push_back(e);
        if (!pair_two_sides(triangles_, sides, partner_) && sides.size() > 1) here.rings.push_back(e);
      }
    };
    if (!for_each_range(edges_.count(), kItems, &progress, pair)) return cancelled();
    std::vector<uint32_t> non_manifold;
    for (const Found& f : found) {
      report_.boundary_edges += f.boundary;
      non_manifold.insert(non_manifold.end(), f.non_manifold.begin(), f.non_manifold.end());
      rings_.insert(rings_.end(), f.rings.begin(), f.rings.end());
    }
    report_.non_manifold_edges = non_manifold.size();
    pair_sides_of_shells(soup_.positions, triangles_, edges_, non_manifold, patch_of_, partner_);
    record_doubled(count_doubled(rings_));
    return Done{};
  }

  // Returns the number of triangles with the corners of an earlier one in the same order.
  size_t count_doubled(std::span<const uint32_t> edges) const {
    std::vector<uint32_t> doubled;
    for (const uint32_t e : edges) {
      const auto sides = edges_.sides_of(e);
      std::map<std::pair<uint32_t, uint32_t>, uint32_t> first;  // by tail and opposite corner
      for (const uint32_t s : sides) {
        if (!first.try_emplace({tail(s), tail(previous_side(s))}, s).second) doubled.push_back(s / 3);
      }
    }
    std::sort(doubled.begin(), doubled.end());
    return static_cast<size_t>(std::unique(doubled.begin(), doubled.end()) - doubled.begin());
  }

  void record_doubled(size_t faces) {
    if (faces == 0) return;
    report_.warnings.push_back(
        grouped(faces) + (faces == 1 ? " face coincides with another one and faces the same way: the volume "
                                       "that it bounds counts twice."
                                     : " faces coincide with others and face the same way: the volume that "
                                       "they bound counts twice."));
  }

  Status find_vertices(const Progress& progress) {
    auto fans = name_vertices(triangles_, soup_.positions.size(), partner_, &progress);
    if (const Status named = unpack(std::move(fans), fans_); !named) return named;
    count_vertices();
    record_other_colours();
    return Done{};
  }

  void count_vertices() {
    std::vector<bool> used(soup_.positions.size());
    for (const uint32_t p : fans_.position) used[p] = true;
    for (size_t p = 0; p < soup_.positions.size(); ++p) {
      if (!used[welded_[p]])
        ++report_.repairs.isolated_vertices_dropped;
      else if (welded_[p] != p)
        ++report_.repairs.welded_vertices;
      else
        ++report_.vertices;
    }
    report_.repairs.duplicated_vertices = fans_.count() - report_.vertices;
  }

  void record_other_colours() {
    size_t others = 0;
    for (size_t p = 0; p < soup_.colours.size(); ++p) others += soup_.colours[p] != soup_.colours[welded_[p]];
    if (others == 0) return;
    report_.warnings.push_back(
        grouped(others) +
        (others == 1 ? " vertex has a different colour from an earlier one at its position, "
                     : " vertices have different colours from earlier ones at their positions, ") +
        "whose colour was kept.");
  }

  void colour_vertices() {
    for (uint32_t v = 0; v < fans_.count() && !soup_.colours.empty(); ++v)
      mesh_.colours().set(VertexId(v), soup_.colours[fans_.position[v]]);
  }

  Status fill_mesh(const Progress& progress) {
    HalfEdges& m = mesh_.kernel().half_edges;
    auto half_edges = fill_half_edges(m, triangles_, partner_, fans_.last_side, &progress);
    if (!half_edges) return half_edges.error();
    for_each_range(fans_.count(), kItems, [&](size_t first, size_t end) {
      for (auto v = static_cast<uint32_t>(first); v < end; ++v)
        m.set_position(VertexId(v), soup_.positions[fans_.position[v]]);
    });
    colour_vertices();
    auto& data = mesh_.kernel().faces;
    data.grow_to(static_cast<uint32_t>(triangles_.size()));
    for_each_range(triangles_.size(), kItems, [&](size_t first, size_t end) {
      for (auto t = static_cast<uint32_t>(first); t < end; ++t)
        data.edit(t) = {.base = FaceId(t), .material = materials_.empty() ? uint16_t{0} : materials_[t]};
    });
    mesh_.kernel().live_faces = static_cast<uint32_t>(triangles_.size());
    link_rings(*half_edges);
    return Done{};
  }

  void link_rings(const std::vector<HalfEdgeId>& half_edge) {
    KERF_ASSERT(half_edge.size() == 3 * triangles_.size());
    for (const uint32_t e : rings_) {
      const auto sides = edges_.sides_of(e);
      const auto start = [&](uint32_t side) { return fans_.position[tail(side)]; };
      std::vector<HalfEdgeId> members;
      for (const uint32_t s : sides) {
        if (partner_[s] != kNoSide && partner_[s] < s) continue;  // both sides have one edge
        members.push_back(start(s) == start(sides[0]) ? half_edge[s] : opposite(half_edge[s]));
      }
      link_ring(mesh_.kernel(), members);
    }
  }

  Status measure(const Progress& progress) {
    struct Sum {
      double area = 0;
      size_t without_area = 0;
    };
    std::vector<Sum> sums(range_count(triangles_.size(), kItems));
    const Positions at = mesh_.positions();
    const auto add = [&](size_t t, size_t end) {
      Sum& sum = sums[t / kItems];
      for (; t < end; ++t) {
        const auto& [a, b, c] = triangles_[t];
        const double area = triangle_area({at[a], at[b], at[c]});
        sum.area += area;
        sum.without_area += area == 0;
      }
    };
    if (!for_each_range(triangles_.size(), kItems, &progress, add)) return cancelled();
    for (const Sum& sum : sums) {
      report_.area += sum.area;
      report_.repairs.zero_area_faces += sum.without_area;
    }
    report_.faces = triangles_.size();
    KERF_ASSERT(fans_.count() > 0);
    report_.min = report_.max = at[0];
    for (uint32_t v = 1; v < fans_.count(); ++v) {
      report_.min = glm::min(report_.min, at[v]);
      report_.max = glm::max(report_.max, at[v]);
    }
    if (!(glm::length(report_.max - report_.min) <= kMaxWidth))
      return bad_input("the mesh is wider than 1e150 m; check its coordinates and their unit");
    return Done{};
  }

  const Soup& soup_;
  const Progress* progress_;
  std::vector<uint32_t> welded_;
  std::vector<Soup::Triangle> triangles_;  // corners are welded positions, and vertices after find_vertices()
  std::vector<uint16_t> materials_;        // by triangle, or empty if all are 0
  std::vector<MeshPart> parts_;            // of triangles_
  std::vector<uint32_t> sources_;          // by triangle: its index in the soup; empty if they are the same
  std::vector<bool> turned_;               // by triangle: turned from its orientation in the file
  SoupEdges edges_;
  std::vector<uint32_t> patch_of_;  // by triangle
  std::vector<uint32_t> partner_;   // by side: the side that its edge links it with, or kNoSide
  std::vector<uint32_t> rings_;     // the edges that become rings, ascending
  VertexFans fans_;
  Mesh mesh_;
  MeshReport report_;
};

}  // namespace

Result<BuiltMesh> build_mesh(const Soup& soup, const Progress* progress) {
  return Builder(soup, progress).build();
}

}  // namespace kerf
