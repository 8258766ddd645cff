#include "tests/fuzz/strokes/world_check.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <numeric>

#include "core/base/containers.h"
#include "core/edit/separation.h"
#include "core/graph/component_graph.h"
#include "core/tree/tree_internal.h"
#include "tests/support/energy.h"
#include "tests/support/mesh_numbers.h"
#include "tests/support/piece_sums.h"

namespace kerf::fuzz {

namespace {

void check_faces(const Body& body) {
  const Mesh& mesh = body.mesh;
  for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
    if (!mesh.is_live(FaceId(f))) continue;
    const Triangle t = mesh.triangle(FaceId(f));
    for (const Vec3& p : t)
      require(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z),
              "a position that is not finite");
    // Splitting a face without area may bring two of its corners to one place.
    require(t[0] != t[1] || t[1] != t[2], "a face with three corners at one place");
  }
  const std::string fault = test::find_fault(mesh, true);
  require(fault.empty(), "not conforming: " + fault);
}

std::vector<RayHit> all_crossings(const Mesh& mesh, const Pose& ray) {
  const ShearedRay sheared(ray);
  std::vector<RayHit> hits;
  for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
    if (!mesh.is_live(FaceId(f))) continue;
    const auto length = sheared.cross(mesh.triangle(FaceId(f)));
    if (length && *length >= 0) hits.push_back({FaceId(f), *length});
  }
  std::sort(hits.begin(), hits.end(), [](const RayHit& a, const RayHit& b) {
    return a.length != b.length ? a.length < b.length : a.face < b.face;
  });
  return hits;
}

// Rays through the middles of a few faces, which meet something.
void check_tree(const Body& body) {
  const Mesh& mesh = body.mesh;
  require(body.tree.leaf_count() == mesh.live_faces(), "the tree has another number of faces");
  const double far = 1e3 + 10 * glm::length(body.bounds().max - body.bounds().min);
  const uint32_t stride = 1 + mesh.face_slots() / 4;
  for (uint32_t f = 0; f < mesh.face_slots(); f += stride) {
    if (!mesh.is_live(FaceId(f))) continue;
    const Triangle t = mesh.triangle(FaceId(f));
    const Vec3 direction = glm::normalize(Vec3(1 + f % 3, -2 + static_cast<double>(f % 5), 0.5 + f % 2));
    const Pose ray{(t[0] + t[1] + t[2]) / 3.0 - 0.5 * far * direction, direction};
    const std::vector<RayHit> wanted = all_crossings(mesh, ray);
    std::vector<RayHit> found;
    body.tree.crossings(mesh, ray, {0, 2 * far}, found);
    require(found == wanted, "the tree finds other faces on a ray than a full search");
    const auto nearest = body.tree.nearest(mesh, ray, {0, 2 * far});
    require(nearest.has_value() == !wanted.empty() && (!nearest || *nearest == wanted[0]),
            "another nearest hit");
  }
}

// Each component of the full search has one label.
void check_labels(const Body& body) {
  std::vector<uint32_t> component;
  label_components(body.mesh, component);
  std::map<uint32_t, uint32_t> label_of;
  for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
    if (!body.mesh.is_live(FaceId(f))) continue;
    const uint32_t label = body.mesh.data(FaceId(f)).piece;
    require(label_of.try_emplace(component[f], label).first->second == label, "two labels in one component");
  }
  test::expect_piece_sums(body);
}

// The graph falls into as many parts as the full search finds.
void check_graph(const World& world) {
  size_t components = 0;
  for (const BodyId id : world.ids()) {
    std::vector<uint32_t> label;
    components += label_components(world.body(id).mesh, label);
  }
  const ComponentGraph graph = component_graph(world);
  std::vector<uint32_t> parent(graph.nodes.size());
  std::iota(parent.begin(), parent.end(), 0u);
  const auto root = [&](uint32_t x) {
    while (parent[x] != x) x = parent[x] = parent[parent[x]];
    return x;
  };
  size_t parts = graph.nodes.size();
  for (const auto& [a, b] : graph.edges) {
    const uint32_t from = root(a), to = root(b);
    parts -= from != to;
    parent[from] = to;
  }
  require(parts == components, "the graph falls into other parts than a full search finds");
}

}  // namespace

void require(bool holds, const std::string& what) {
  if (holds) return;
  std::fprintf(stderr, "kerf: broken: %s\n", what.c_str());
  std::abort();
}

void check_world(const World& world) {
  for (const BodyId id : world.ids()) {
    const Body& body = world.body(id);
    check_faces(body);
    check_tree(body);
    if (is_settled(body)) check_labels(body);
  }
  check_graph(world);
  test::expect_closed_ledger(world, 1e-6);
}

void check_closed(const World& world) {
  std::vector<Mesh::Side> open;
  for (const BodyId id : world.ids()) {
    require(world.body(id).solid, "a body that came off a solid is none");
    world.body(id).mesh.append_open_sides(open);
  }
  require(open.empty(), "an open side of which nothing was said");
}

}  // namespace kerf::fuzz
