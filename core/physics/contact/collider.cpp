#include "core/physics/contact/collider.h"

#include <numeric>

#include "core/base/assert.h"
#include "core/mesh/face_batches.h"

namespace kerf {

namespace {

constexpr uint32_t kMaxInLeaf = 8;
constexpr uint32_t kSmaller =
    4;  // min ratio to the size of the enclosing cluster, unless the cluster holds items

constexpr size_t kMaxCandidates = 1024;

struct VertexNormals {
  std::vector<Vec3> of_face;     // unit, by slot
  std::vector<Vec3> of_vertex;   // sums weighted by area, by slot
  std::vector<double> areas_at;  // twice the areas of the faces of a vertex, by slot
  std::vector<VertexId> used;    // vertices of live faces, ascending
};

VertexNormals normals_of(const Mesh& mesh) {
  VertexNormals n;
  n.of_face.resize(mesh.face_slots(), Vec3(0));
  n.of_vertex.resize(mesh.vertex_slots(), Vec3(0));
  n.areas_at.resize(mesh.vertex_slots(), 0);
  std::vector<bool> seen(mesh.vertex_slots(), false);
  for_each_batch(mesh, 0, mesh.face_slots(), [&](const TriangleBatch& batch) {
    for (uint32_t i = 0; i < batch.count(); ++i) {
      const Triangle& t = batch.triangle(i);
      const Vec3 area = glm::cross(t[1] - t[0], t[2] - t[0]);
      const double length = glm::length(area);
      if (length > 0) n.of_face[batch.face(i).index] = area / length;
      for (VertexId v : batch.corners(i)) {
        n.of_vertex[v.index] += area;
        n.areas_at[v.index] += length;
        seen[v.index] = true;
      }
    }
  });
  for (uint32_t v = 0; v < seen.size(); ++v) {
    if (seen[v]) n.used.push_back(VertexId(v));
  }
  return n;
}

// Returns at most `most` of the vertices, evenly over their order.
std::vector<VertexId> thinned(const std::vector<VertexId>& all, size_t most) {
  if (all.size() <= most) return all;
  std::vector<VertexId> some(most);
  for (size_t i = 0; i < some.size(); ++i) some[i] = all[i * all.size() / some.size()];
  return some;
}

// Returns the sums of the directions in which the sheet ends at the vertices of rims.
std::vector<Vec3> outward_at_rims(const Mesh& mesh, const std::vector<FeatureEdge>& edges,
                                  const VertexNormals& normals) {
  std::vector<Vec3> outward(mesh.vertex_slots(), Vec3(0));
  for (const FeatureEdge& e : edges) {
    if (!e.rim) continue;
    const Vec3 along = mesh.position(e.to) - mesh.position(e.from);
    const Vec3 out = glm::cross(along, normals.of_face[e.face.index]);
    outward[e.from.index] += out;
    outward[e.to.index] += out;
  }
  return outward;
}

Vec3 unit_or_zero(const Vec3& v) {
  const double length = glm::length(v);
  return length > 0 ? v / length : Vec3(0);
}

// A subset of the vertices of a mesh.
struct Vertices {
  std::vector<bool> has;       // by slot
  std::vector<VertexId> list;  // ascending
};

Vertices on_lines(const Mesh& mesh, const std::vector<FeatureEdge>& edges, bool rims_only) {
  Vertices vertices{std::vector<bool>(mesh.vertex_slots(), false), {}};
  for (const FeatureEdge& e : edges) {
    if (e.rim || !rims_only) vertices.has[e.from.index] = vertices.has[e.to.index] = true;
  }
  for (uint32_t v = 0; v < vertices.has.size(); ++v) {
    if (vertices.has[v]) vertices.list.push_back(VertexId(v));
  }
  return vertices;
}

std::vector<VertexId> selected_vertices(const Mesh& mesh, const Vertices& rims,
                                        const std::vector<VertexId>& all, size_t most) {
  std::vector<VertexId> candidates = thinned(rims.list, kMaxCandidates);
  const size_t on_rim = candidates.size();
  for (VertexId v : thinned(all, kMaxCandidates)) {
    if (!rims.has[v.index]) candidates.push_back(v);
  }
  std::vector<Vec3> places;
  for (VertexId v : candidates) places.push_back(mesh.position(v));
  std::vector<uint32_t> selected;
  select_extreme(places, selected);
  if (selected.size() > most) selected.resize(most);
  // Half of the rest is on rims, where sheets get caught.
  const std::vector<Vec3> rim_places(places.begin(), places.begin() + static_cast<ptrdiff_t>(on_rim));
  std::vector<uint32_t> selected_rims;
  for (uint32_t c : selected) {
    if (c < on_rim) selected_rims.push_back(c);
  }
  const size_t before = selected_rims.size();
  select_spread_points(rim_places, before + (most - selected.size()) / 2, selected_rims);
  selected.insert(selected.end(), selected_rims.begin() + static_cast<ptrdiff_t>(before),
                  selected_rims.end());
  select_spread_points(places, most, selected);
  std::vector<VertexId> vertices;
  for (uint32_t c : selected) vertices.push_back(candidates[c]);
  return vertices;
}

// Feature lines of a mesh, which can be simplified by increasing errors.
class Lines {
 public:
  Lines(const Mesh& mesh, const std::vector<FeatureEdge>& edges, double least_error) {
    const Positions at = mesh.positions();
    for (const FeatureLine& line : joined(edges)) {
      Line& own = lines_.emplace_back();
      for (VertexId v : line) own.places.push_back(at[v]);
      own.omission_errors = omission_errors(own.places, least_error);
    }
  }

  size_t count_chords(double error) const {
    size_t count = 0;
    for (const Line& line : lines_) {
      for (const double from : line.omission_errors) count += from > error * error;
    }
    KERF_ASSERT(count >= lines_.size());
    return count - lines_.size();
  }

  std::vector<Collider::Chord> chords(double error) const {
    std::vector<Collider::Chord> chords;
    for (const Line& line : lines_) {
      KERF_ASSERT(!line.places.empty() && line.omission_errors.size() == line.places.size());
      Vec3 from = line.places.front();
      for (size_t i = 1; i < line.places.size(); ++i) {
        if (!(line.omission_errors[i] > error * error)) continue;
        chords.push_back({from, line.places[i]});
        from = line.places[i];
      }
    }
    return chords;
  }

 private:
  struct Line {
    std::vector<Vec3> places;
    std::vector<double> omission_errors;
  };
  std::vector<Line> lines_;
};

// Returns at most `most` chords, with the smallest tried error, from `error` on, that yields so few.
std::vector<Collider::Chord> chords_of(const Lines& lines, double error, size_t most) {
  // An open line keeps one chord, a closed one two, so that lines alone may be too many.
  for (int i = 0; i < 16 && lines.count_chords(error) > most; ++i) error *= 2;
  std::vector<Collider::Chord> chords = lines.chords(error);
  if (chords.size() > most) {
    const auto longer = [](const Collider::Chord& a, const Collider::Chord& b) {
      return glm::length(a.to - a.from) > glm::length(b.to - b.from);
    };
    std::stable_sort(chords.begin(), chords.end(), longer);
    chords.resize(most);
  }
  return chords;
}

// Returns the vertices at ends of chords: a sheet passes through another there first, or edge by edge.
std::vector<VertexId> ends_of(const std::vector<Collider::Chord>& chords, const Mesh& mesh,
                              const std::vector<VertexId>& on_lines) {
  std::vector<Vec3> ends;
  for (const Collider::Chord& c : chords) ends.insert(ends.end(), {c.from, c.to});
  std::sort(ends.begin(), ends.end(), lexicographic_less);
  std::vector<VertexId> vertices;
  for (VertexId v : on_lines) {
    if (std::binary_search(ends.begin(), ends.end(), mesh.position(v), lexicographic_less))
      vertices.push_back(v);
  }
  return vertices;
}

// Returns all vertices except those amid flat faces, which lie between others unless they end lines or seams.
std::vector<Vec3> corners_of(const Mesh& mesh, const VertexNormals& normals, const FeatureEdges& edges) {
  constexpr double kFlat = 1 - 1e-9;  // cosine of the mean angle to the mean normal
  std::vector<bool> ends(mesh.vertex_slots(), false);
  std::vector<Mesh::Side> sides;
  for (const std::vector<FeatureEdge>* list : {&edges.lines, &edges.seams}) {
    for (const FeatureEdge& e : *list) {
      sides.assign({{e.face, e.from, e.to}});
      mesh.append_edge_sides(e.face, e.from, e.to, sides);
      for (const Mesh::Side& side : sides) ends[side.from.index] = ends[side.to.index] = true;
    }
  }
  std::vector<Vec3> corners;
  for (const VertexId v : normals.used) {
    const bool flat = glm::length(normals.of_vertex[v.index]) > kFlat * normals.areas_at[v.index];
    if (!flat || ends[v.index]) corners.push_back(mesh.position(v));
  }
  return corners;
}

Occupancy space_of(const Mesh& mesh, const Collider& collider) {
  Occupancy space(collider.bounds);
  for_each_triangle(mesh, 0, mesh.face_slots(), [&](FaceId, const Triangle& t) {
    space.add({glm::min(glm::min(t[0], t[1]), t[2]), glm::max(glm::max(t[0], t[1]), t[2])});
  });
  for (const Collider::Chord& c : collider.chords)
    space.add({glm::min(c.from, c.to), glm::max(c.from, c.to)});
  return space;
}

std::array<Vec3, 2> segment_of(const Collider::Point& p) { return {p.at, p.at}; }
std::array<Vec3, 2> segment_of(const Collider::Chord& c) { return {c.from, c.to}; }

// Sorts points or chords by clusters. Returns the clusters.
template <typename Item>
Clusters sort_by_clusters(std::vector<Item>& items) {
  std::vector<std::array<Vec3, 2>> segments;
  for (const Item& item : items) segments.push_back(segment_of(item));
  Clustering clustering = make_clusters(segments);
  KERF_ASSERT(clustering.order.size() == items.size());
  std::vector<Item> sorted;
  for (uint32_t i : clustering.order) sorted.push_back(items[i]);
  items = std::move(sorted);
  return std::move(clustering.clusters);
}

constexpr double kCreaseCosine = 0.766;  // cos(40 degrees)

// Edges by the vertices at their ends.
class Ends {
 public:
  explicit Ends(const std::vector<FeatureEdge>& edges) {
    uint32_t vertices = 0;
    for (const FeatureEdge& e : edges) vertices = std::max({vertices, e.from.index + 1, e.to.index + 1});
    first_.resize(size_t{vertices} + 1, 0);
    for (const FeatureEdge& e : edges) {
      ++first_[e.from.index];
      ++first_[e.to.index];
    }
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    edges_.resize(2 * edges.size());
    for (auto e = static_cast<uint32_t>(edges.size()); e-- > 0;) {
      edges_[--first_[edges[e].to.index]] = e;
      edges_[--first_[edges[e].from.index]] = e;
    }
  }
  // Returns indices of edges, ascending. Precondition: an edge ends there.
  std::span<const uint32_t> at(VertexId v) const {
    KERF_ASSERT(v.index + size_t{1} < first_.size());
    return std::span(edges_).subspan(first_[v.index], first_[v.index + 1] - first_[v.index]);
  }

 private:
  std::vector<uint32_t> edges_;
  std::vector<uint32_t> first_;  // by vertex: index in edges_
};

// Follows edges from one end until the line branches, ends or closes.
FeatureLine follow(const std::vector<FeatureEdge>& edges, const Ends& ends, uint32_t edge, VertexId start,
                   std::vector<bool>& used) {
  KERF_ASSERT(!used[edge] && (edges[edge].from == start || edges[edge].to == start));
  FeatureLine line{start};
  while (true) {
    used[edge] = true;
    const VertexId next = edges[edge].from == line.back() ? edges[edge].to : edges[edge].from;
    line.push_back(next);
    const std::span<const uint32_t> there = ends.at(next);
    if (there.size() != 2) return line;
    edge = there[0] == edge ? there[1] : there[0];
    if (used[edge]) return line;
  }
}

double squared_distance_to_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 along = b - a, to = p - a;
  const double length2 = glm::dot(along, along);
  const double t = length2 > 0 ? std::clamp(glm::dot(to, along) / length2, 0.0, 1.0) : 0;
  const Vec3 off = to - t * along;
  return glm::dot(off, off);
}

}  // namespace

class ClusterDivision {
 public:
  ClusterDivision(std::span<const std::array<Vec3, 2>> segments, Clustering& out)
      : segments_(segments), out_(out) {
    for (const std::array<Vec3, 2>& s : segments) middles_.push_back(0.5 * (s[0] + s[1]));
  }

  // `around`: the number of items of the enclosing cluster.
  void divide(uint32_t begin, uint32_t end, uint32_t around) {
    const bool holds_items = end - begin <= kMaxInLeaf;
    const bool is_node = holds_items || kSmaller * (end - begin) <= around;
    const size_t node = out_.clusters.nodes_.size();
    if (is_node) out_.clusters.nodes_.push_back({ball_around(begin, end), 0});
    if (!holds_items) halve(begin, end, is_node ? end - begin : around);
    if (is_node) out_.clusters.nodes_[node].next = static_cast<uint32_t>(out_.clusters.nodes_.size());
  }

 private:
  void halve(uint32_t begin, uint32_t end, uint32_t around) {
    KERF_ASSERT(begin + 1 < end);
    const int axis = widest_axis(begin, end);
    const auto first = out_.order.begin();
    std::stable_sort(first + begin, first + end,
                     [&](uint32_t a, uint32_t b) { return middles_[a][axis] < middles_[b][axis]; });
    const uint32_t half = begin + (end - begin) / 2;
    divide(begin, half, around);
    divide(half, end, around);
  }

  int widest_axis(uint32_t begin, uint32_t end) const {
    Box box;
    for (uint32_t i = begin; i < end; ++i) box.add(middles_[out_.order[i]]);
    return box.widest_axis();
  }

  Cluster ball_around(uint32_t begin, uint32_t end) const {
    KERF_ASSERT(begin < end && end <= out_.order.size());
    Box box;
    for (uint32_t i = begin; i < end; ++i) {
      for (const Vec3& p : segments_[out_.order[i]]) box.add(p);
    }
    Cluster cluster{begin, end, 0.5 * (box.min + box.max), 0};
    for (uint32_t i = begin; i < end; ++i) {
      for (const Vec3& p : segments_[out_.order[i]])
        cluster.radius = std::max(cluster.radius, glm::length(p - cluster.centre));
    }
    return cluster;
  }

  std::span<const std::array<Vec3, 2>> segments_;
  std::vector<Vec3> middles_;  // of the segments
  Clustering& out_;
};

Clustering make_clusters(std::span<const std::array<Vec3, 2>> segments) {
  Clustering out;
  if (segments.empty()) return out;
  out.order.resize(segments.size());
  std::iota(out.order.begin(), out.order.end(), 0u);
  const auto count = static_cast<uint32_t>(segments.size());
  ClusterDivision(segments, out).divide(0, count, kSmaller * count);
  return out;
}

Occupancy::Occupancy(const Box& bounds) : bounds_(bounds) {
  KERF_ASSERT(bounds.min.x <= bounds.max.x && bounds.min.y <= bounds.max.y && bounds.min.z <= bounds.max.z);
  const Vec3 extent = bounds.max - bounds.min;
  const double longest = std::max({extent.x, extent.y, extent.z});
  per_metre_ = longest > 0 ? kMaxCells / longest : 0;
  for (int k = 0; k < 3; ++k) {
    count_[k] = std::min(static_cast<int>(extent[k] * per_metre_) + 1, kMaxCells);
    last_[k] = count_[k] - 1;
  }
  rows_.resize(static_cast<size_t>(count_[1]) * static_cast<size_t>(count_[2]), 0);
}

void Occupancy::add(const Box& box) {
  Range range;
  if (!cells_of(box, range)) return;
  const uint64_t bits = row_bits(range);
  for (int z = range.first[2]; z <= range.last[2]; ++z) {
    for (int y = range.first[1]; y <= range.last[1]; ++y)
      rows_[static_cast<size_t>(y + z * count_[1])] |= bits;
  }
}

Collider make_collider(const Mesh& mesh, const ColliderSettings& settings) {
  KERF_ASSERT(settings.max_points > 0 && settings.chord_error > 0);
  const VertexNormals normals = normals_of(mesh);
  const FeatureEdges edges = feature_edges(mesh, normals.of_face);
  const std::vector<Vec3> outward = outward_at_rims(mesh, edges.lines, normals);
  const Vertices rims = on_lines(mesh, edges.lines, true);
  Collider collider;
  const Lines lines(mesh, edges.lines, settings.chord_error);
  collider.chords = chords_of(lines, settings.chord_error, settings.max_chords);
  std::vector<VertexId> vertices = ends_of(collider.chords, mesh, on_lines(mesh, edges.lines, false).list);
  if (vertices.size() > settings.max_points) vertices.resize(settings.max_points);
  const size_t more = settings.max_points - vertices.size();
  for (VertexId v : selected_vertices(mesh, rims, normals.used, more)) {
    if (std::find(vertices.begin(), vertices.end(), v) == vertices.end()) vertices.push_back(v);
  }
  const auto point_at = [&](VertexId v) -> Collider::Point {
    return {mesh.position(v), unit_or_zero(normals.of_vertex[v.index]), unit_or_zero(outward[v.index])};
  };
  std::vector<bool> is_point(mesh.vertex_slots(), false);
  for (VertexId v : vertices) {
    collider.points.push_back(point_at(v));
    is_point[v.index] = true;
  }
  for (VertexId v : thinned(normals.used, settings.max_guards)) {
    if (!is_point[v.index]) collider.guards.push_back(point_at(v));
  }
  for (VertexId v : normals.used) collider.bounds.add(mesh.position(v));
  if (!normals.used.empty()) collider.space = space_of(mesh, collider);
  KERF_ASSERT(collider.points.size() <= settings.max_points);
  KERF_ASSERT(collider.chords.size() <= settings.max_chords);
  collider.corners = corners_of(mesh, normals, edges);
  collider.point_clusters = sort_by_clusters(collider.points);
  collider.chord_clusters = sort_by_clusters(collider.chords);
  collider.guard_clusters = sort_by_clusters(collider.guards);
  if (lines.count_chords(settings.chord_error) > settings.max_chords) {
    collider.fine_chords = chords_of(lines, settings.chord_error, settings.max_fine_chords);
    collider.fine_chord_clusters = sort_by_clusters(collider.fine_chords);
  } else {
    collider.fine_chords = collider.chords;
    collider.fine_chord_clusters = collider.chord_clusters;
  }
  return collider;
}

FeatureEdges feature_edges(const Mesh& mesh, const std::vector<Vec3>& normals) {
  KERF_ASSERT(normals.size() == mesh.face_slots());
  FeatureEdges edges;
  std::vector<Mesh::Side> sides;
  for (uint32_t slot = 0; slot < mesh.face_slots(); ++slot) {
    const FaceId f(slot);
    if (!mesh.is_live(f)) continue;
    const auto bends_to = [&](FaceId other) {
      return glm::dot(normals[slot], normals[other.index]) < kCreaseCosine;
    };
    for (const auto& [from, to, across, is_shared] : sheet_edges_of(mesh, f)) {
      if (!is_shared) {
        const bool rim = !across.valid();
        if (rim || (f < across && bends_to(across))) edges.lines.push_back({from, to, f, rim});
        continue;
      }
      sides.clear();
      mesh.append_edge_sides(f, from, to, sides);
      if (sides.empty()) {
        edges.lines.push_back({from, to, f, true});
        continue;
      }
      const bool first =
          std::all_of(sides.begin(), sides.end(), [&](const Mesh::Side& s) { return f < s.face; });
      if (!first) continue;
      const bool bends =
          std::any_of(sides.begin(), sides.end(), [&](const Mesh::Side& s) { return bends_to(s.face); });
      if (bends || sides.size() > 1) (bends ? edges.lines : edges.seams).push_back({from, to, f, false});
    }
  }
  return edges;
}

std::vector<FeatureLine> joined(const std::vector<FeatureEdge>& edges) {
  const Ends ends(edges);
  std::vector<bool> used(edges.size(), false);
  std::vector<FeatureLine> lines;
  const auto begin_at = [&](uint32_t e, VertexId v) {
    if (!used[e]) lines.push_back(follow(edges, ends, e, v, used));
  };
  for (uint32_t e = 0; e < edges.size(); ++e) {
    if (ends.at(edges[e].from).size() != 2) begin_at(e, edges[e].from);
    if (ends.at(edges[e].to).size() != 2) begin_at(e, edges[e].to);
  }
  for (uint32_t e = 0; e < edges.size(); ++e) begin_at(e, edges[e].from);
  return lines;
}

std::vector<double> omission_errors(const std::vector<Vec3>& line, double least_error) {
  KERF_ASSERT(least_error >= 0);
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (line.size() < 3) return std::vector<double>(line.size(), kInfinity);
  std::vector<double> from(line.size(), 0);
  from.front() = from.back() = kInfinity;
  struct Part {
    size_t first, last;
    double most;  // the part is not divided for larger squared errors
  };
  std::vector<Part> parts{{0, line.size() - 1, kInfinity}};
  bool must_divide = line.front() == line.back();
  while (!parts.empty()) {
    const Part part = parts.back();
    parts.pop_back();
    size_t farthest = part.first;
    double most = must_divide ? 0 : least_error * least_error;
    for (size_t i = part.first + 1; i < part.last; ++i) {
      const double d = squared_distance_to_segment(line[i], line[part.first], line[part.last]);
      if (d > most) {
        most = d;
        farthest = i;
      }
    }
    if (farthest != part.first) {
      from[farthest] = must_divide ? kInfinity : std::min(part.most, most);
      parts.push_back({part.first, farthest, from[farthest]});
      parts.push_back({farthest, part.last, from[farthest]});
    }
    must_divide = false;
  }
  return from;
}

std::vector<Vec3> simplified(const std::vector<Vec3>& line, double error) {
  const std::vector<double> from = omission_errors(line, error);
  std::vector<Vec3> few;
  for (size_t i = 0; i < line.size(); ++i) {
    if (from[i] > error * error) few.push_back(line[i]);
  }
  return few;
}

void select_spread_points(const std::vector<Vec3>& points, size_t most, std::vector<uint32_t>& selected) {
  if (points.empty()) return;
  std::vector<double> apart(points.size(), std::numeric_limits<double>::infinity());
  uint32_t farthest = 0;
  const auto measure_from = [&](uint32_t c) {
    KERF_ASSERT(c < points.size());
    double longest = -1;
    for (uint32_t i = 0; i < points.size(); ++i) {
      const Vec3 d = points[i] - points[c];
      apart[i] = std::min(apart[i], glm::dot(d, d));
      if (apart[i] > longest) longest = apart[i], farthest = i;
    }
  };
  for (uint32_t c : selected) measure_from(c);
  while (selected.size() < most && apart[farthest] > 0) {
    selected.push_back(farthest);
    measure_from(farthest);
  }
}

void select_extreme(const std::vector<Vec3>& points, std::vector<uint32_t>& selected) {
  if (points.empty()) return;
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      for (int z = -1; z <= 1; ++z) {
        if (std::abs(x) + std::abs(y) + std::abs(z) == 2 || (x == 0 && y == 0 && z == 0)) continue;
        const Vec3 way(x, y, z);
        uint32_t best = 0;
        double most = glm::dot(points[0], way);
        for (uint32_t i = 1; i < points.size(); ++i) {
          const double at = glm::dot(points[i], way);
          if (at > most) most = at, best = i;
        }
        if (std::find(selected.begin(), selected.end(), best) == selected.end()) selected.push_back(best);
      }
    }
  }
}

}  // namespace kerf
