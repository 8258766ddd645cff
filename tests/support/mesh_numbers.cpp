#include "tests/support/mesh_numbers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "core/base/containers.h"
#include "core/edit/separation.h"

namespace kerf::test {

namespace {

struct Less {
  bool operator()(const Vec3& a, const Vec3& b) const {
    if (a.x != b.x) return a.x < b.x;
    return a.y != b.y ? a.y < b.y : a.z < b.z;
  }
};

// The live faces by position.
struct Picture {
  std::map<Vec3, uint32_t, Less> vertices;
  std::map<std::pair<uint32_t, uint32_t>, std::vector<FaceId>> edges;  // ascending
  std::vector<FaceId> faces;
  std::set<std::array<uint32_t, 3>> different;  // faces by their corners, so that copies count once

  uint32_t number(const Vec3& p) {
    return vertices.try_emplace(p, static_cast<uint32_t>(vertices.size())).first->second;
  }
};

Picture look_at(const Mesh& mesh) {
  Picture p;
  for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
    if (!mesh.is_live(FaceId(f))) continue;
    p.faces.emplace_back(f);
    const Triangle t = mesh.triangle(FaceId(f));
    std::array<uint32_t, 3> corners = {p.number(t[0]), p.number(t[1]), p.number(t[2])};
    for (int i = 0; i < 3; ++i) p.edges[std::minmax(corners[i], corners[(i + 1) % 3])].emplace_back(f);
    std::sort(corners.begin(), corners.end());
    p.different.insert(corners);
  }
  return p;
}

// Of so many faces at an edge some are asked: each of them says as many neighbours.
constexpr size_t kMaxAsked = 16;

bool has_requests(const std::vector<FaceId>& faces, FaceId f) {
  if (faces.size() <= kMaxAsked) return true;
  const auto place = static_cast<size_t>(std::lower_bound(faces.begin(), faces.end(), f) - faces.begin());
  return place % (faces.size() / kMaxAsked) == 0;
}

std::string wrong_neighbours(const Mesh& mesh, Picture& p, FaceId f, bool chance_allowed) {
  const Triangle t = mesh.triangle(f);
  const auto corners = mesh.corners(f);
  std::vector<Mesh::Side> sides;
  std::vector<FaceId> listed;
  for (int i = 0; i < 3; ++i) {
    const std::vector<FaceId>& true_ones = p.edges[std::minmax(p.number(t[i]), p.number(t[(i + 1) % 3]))];
    if (!has_requests(true_ones, f)) continue;
    sides.clear();
    listed.assign(1, f);
    mesh.append_edge_sides(f, corners[i], corners[(i + 1) % 3], sides);
    for (const Mesh::Side& side : sides) listed.push_back(side.face);
    std::sort(listed.begin(), listed.end());
    const bool right = chance_allowed
                           ? std::includes(true_ones.begin(), true_ones.end(), listed.begin(), listed.end())
                           : listed == true_ones;
    if (!right) return "face " + std::to_string(f.index) + " has other neighbours than its edge has faces";
  }
  return {};
}

std::string hanging_node(Picture& p) {
  std::vector<Vec3> position(p.vertices.size());
  for (const auto& [at, number] : p.vertices) position[number] = at;
  for (const auto& [ends, faces] : p.edges) {
    if (faces.size() != 1) continue;
    const Vec3 middle = 0.5 * position[ends.first] + 0.5 * position[ends.second];
    const auto found = p.vertices.find(middle);
    if (found == p.vertices.end()) continue;
    const uint32_t m = found->second;
    if (m == ends.first || m == ends.second) continue;
    if (p.edges.count(std::minmax(ends.first, m)) && p.edges.count(std::minmax(ends.second, m))) {
      return "a node hangs on an edge of face " + std::to_string(faces[0].index);
    }
  }
  return {};
}

}  // namespace

MeshNumbers count_numbers(const Mesh& mesh) {
  const Picture p = look_at(mesh);
  MeshNumbers n;
  std::map<uint32_t, uint32_t> place;
  for (uint32_t i = 0; i < p.faces.size(); ++i) place[p.faces[i].index] = i;
  std::vector<Vec3> position(p.vertices.size());
  for (const auto& [at, number] : p.vertices) position[number] = at;

  UnionFind together(p.faces.size()), loops(p.vertices.size());
  n.components = p.faces.size();
  std::set<uint32_t> on_boundary;
  size_t joined = 0;
  for (const auto& [ends, faces] : p.edges) {
    for (const FaceId f : faces) n.components -= together.unite(place[faces[0].index], place[f.index]);
    if (faces.size() != 1) continue;
    n.boundary_length += glm::length(position[ends.first] - position[ends.second]);
    on_boundary.insert({ends.first, ends.second});
    joined += loops.unite(ends.first, ends.second);
  }
  n.boundary_loops = on_boundary.size() - joined;
  n.euler = static_cast<long>(p.vertices.size()) - static_cast<long>(p.edges.size()) +
            static_cast<long>(p.different.size());
  for (const FaceId f : p.faces) n.area += triangle_area(mesh.triangle(f));
  return n;
}

MeshNumbers count_connected_numbers(const Mesh& mesh) {
  MeshNumbers n;
  UnionFind corner(mesh.vertex_slots()), loops(mesh.vertex_slots());
  double edges = 0;  // each side counts for its share of its edge
  std::vector<std::pair<VertexId, VertexId>> rim;
  std::vector<Mesh::Side> sides;
  const auto visit = [&](auto each) {
    for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
      if (mesh.is_live(FaceId(f))) each(FaceId(f), mesh.corners(FaceId(f)));
    }
  };
  visit([&](FaceId f, const std::array<VertexId, 3>& c) {
    n.area += triangle_area(mesh.triangle(f));
    for (int i = 0; i < 3; ++i) {
      const VertexId from = c[i], to = c[(i + 1) % 3];
      sides.clear();
      mesh.append_edge_sides(f, from, to, sides);
      edges += 1.0 / static_cast<double>(1 + sides.size());
      if (sides.empty()) rim.emplace_back(from, to);
      for (const Mesh::Side& s : sides) {
        if (s.from == to && s.to == from) continue;  // one sheet; also where the edge has no length
        const bool same_way = mesh.position(s.from) == mesh.position(from);
        corner.unite(from.index, same_way ? s.from.index : s.to.index);
        corner.unite(to.index, same_way ? s.to.index : s.from.index);
      }
    }
  });
  std::set<uint32_t> vertices, on_rim;
  std::set<std::array<uint32_t, 3>> faces;
  visit([&](FaceId, const std::array<VertexId, 3>& c) {
    std::array<uint32_t, 3> face{};
    for (int i = 0; i < 3; ++i) vertices.insert(face[i] = corner.find(c[i].index));
    std::sort(face.begin(), face.end());
    faces.insert(face);
  });
  size_t joined = 0;
  for (const auto& [from, to] : rim) {
    n.boundary_length += glm::length(mesh.position(from) - mesh.position(to));
    on_rim.insert({corner.find(from.index), corner.find(to.index)});
    joined += loops.unite(corner.find(from.index), corner.find(to.index));
  }
  n.boundary_loops = on_rim.size() - joined;
  n.euler =
      static_cast<long>(vertices.size()) - static_cast<long>(edges + 0.5) + static_cast<long>(faces.size());
  std::vector<uint32_t> label;
  n.components = label_components(mesh, label);
  return n;
}

void expect_same(const MeshNumbers& before, const MeshNumbers& after) {
  EXPECT_NEAR(after.area, before.area, 1e-9 * before.area);
  EXPECT_NEAR(after.boundary_length, before.boundary_length, 1e-9 * before.boundary_length);
  EXPECT_EQ(after.boundary_loops, before.boundary_loops);
  EXPECT_EQ(after.euler, before.euler);
  EXPECT_EQ(after.components, before.components);
}

double live_area(const Mesh& mesh) {
  double area = 0;
  for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
    if (mesh.is_live(FaceId(f))) area += triangle_area(mesh.triangle(FaceId(f)));
  }
  return area;
}

FaceId random_live_face(const Mesh& mesh, Random& random) {
  for (;;) {
    const FaceId f(static_cast<uint32_t>(random.below(mesh.face_slots())));
    if (mesh.is_live(f)) return f;
  }
}

std::string find_fault(const Mesh& mesh, bool chance_allowed) {
  Picture p = look_at(mesh);
  if (p.faces.size() != mesh.live_faces()) return "the count of live faces is wrong";
  for (const FaceId f : p.faces) {
    if (const std::string fault = wrong_neighbours(mesh, p, f, chance_allowed); !fault.empty()) return fault;
  }
  return chance_allowed ? std::string() : hanging_node(p);
}

}  // namespace kerf::test
