#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <memory>

#include "core/api/api_internal.h"
#include "core/base/parallel.h"
#include "core/document/stroke_path.h"

namespace kerf {

namespace {

constexpr size_t kQueriesPerBatch = 1024;

// Vectors as given by the caller.
Vec3 vector(const double* of, size_t i) { return {of[3 * i], of[3 * i + 1], of[3 * i + 2]}; }

Status check_finite(const double* vectors, size_t n, const char* name) {
  for (size_t i = 0; i < n; ++i) {
    if (!is_finite(vector(vectors, i)))
      return bad_input(name + ("[" + std::to_string(i)) + "] is not finite");
  }
  return Done{};
}

// Rays as given by the caller.
struct Rays {
  const double *origins, *directions;
  size_t count;
  Interval range;

  Pose pose(size_t i) const { return {vector(origins, i), beam_direction(vector(directions, i))}; }
};

Result<Rays> rays_of(const double* origins, const double* directions, size_t n, const double range[2]) {
  if (n > 0 && (origins == nullptr || directions == nullptr))
    return bad_input("origins and directions: must not be null");
  Rays rays{origins, directions, n, {0, std::numeric_limits<double>::max()}};
  if (range != nullptr) {
    if (!std::isfinite(range[0]) || std::isnan(range[1]) || range[0] < 0 || range[1] < range[0])
      return bad_input("range: must be two lengths in metres, 0 <= min <= max");
    rays.range = {range[0], std::min(range[1], std::numeric_limits<double>::max())};
  }
  if (const Status finite = check_finite(origins, n, "origins"); !finite) return finite.error();
  if (const Status finite = check_finite(directions, n, "directions"); !finite) return finite.error();
  for (size_t i = 0; i < n; ++i) {
    if (vector(directions, i) == Vec3(0)) return bad_input("directions[" + std::to_string(i) + "] is zero");
  }
  return rays;
}

// A point of a face, in the frame of the body.
struct Hit {
  double distance = std::numeric_limits<double>::infinity();
  BodyId body;
  FaceId face;
  Vec3 point{0};
};

Hit nearest(const World& world, const std::vector<BodyId>& ids, const Pose& ray, const Interval& range) {
  Hit first;
  for (const BodyId id : ids) {
    const Body& body = world.body(id);
    const Pose own = body.placement.to_body(ray);
    const auto hit = body.tree.nearest(body.mesh, own, range);
    if (hit && hit->length < first.distance)
      first = {hit->length, id, hit->face, own.origin + hit->length * own.direction};
  }
  return first;
}

void append_all(const World& world, const std::vector<BodyId>& ids, const Pose& ray, const Interval& range,
                std::vector<Hit>& out) {
  std::vector<RayHit> found;
  for (const BodyId id : ids) {
    const Body& body = world.body(id);
    const Pose own = body.placement.to_body(ray);
    found.clear();
    body.tree.crossings(body.mesh, own, range, found);
    for (const RayHit& hit : found)
      out.push_back({hit.length, id, hit.face, own.origin + hit.length * own.direction});
  }
  std::stable_sort(out.begin(), out.end(),
                   [](const Hit& a, const Hit& b) { return a.distance < b.distance; });
}

Hit closest(const World& world, const std::vector<BodyId>& ids, const Vec3& to, double max_distance) {
  Hit first;
  for (const BodyId id : ids) {
    const Body& body = world.body(id);
    const auto near = body.tree.nearest_point(body.mesh, body.placement.to_body(to));
    const double distance = near ? std::sqrt(near->distance2) : first.distance;
    if (distance < first.distance && distance <= max_distance)
      first = {distance, id, near->face, near->point};
  }
  return first;
}

// Returns the barycentric coordinates of a point of a triangle, by the areas in the plane in which its
// projection is largest; the first corner for a triangle without area.
Vec3 barycentrics(const Triangle& t, const Vec3& normal, const Vec3& at) {
  const Vec3 size = glm::abs(normal);
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  const auto area = [&](const Vec3& a, const Vec3& b, const Vec3& c) {
    return (b[u] - a[u]) * (c[v] - a[v]) - (b[v] - a[v]) * (c[u] - a[u]);
  };
  const double whole = area(t[0], t[1], t[2]);
  if (!(std::abs(whole) > 0)) return {1, 0, 0};
  const double second = std::clamp(area(t[0], at, t[2]) / whole, 0.0, 1.0);
  const double third = std::clamp(area(t[0], t[1], at) / whole, 0.0, 1 - second);
  return {1 - second - third, second, third};
}

// Owner of the arrays of a kerf_hits.
struct HitArrays {
  std::vector<size_t> offsets;
  std::vector<double> distances;
  std::vector<kerf_body> bodies;
  std::vector<uint32_t> faces, pieces;
  std::vector<Vec3> barycentrics, positions, normals;
  std::vector<uint16_t> materials;
  std::vector<uint8_t> is_cut;

  // `hits`: n hits, converted in parallel.
  void fill(const World& world, const std::vector<Hit>& hits);
  kerf_hits view() const;
};

void HitArrays::fill(const World& world, const std::vector<Hit>& hits) {
  const size_t n = hits.size();
  distances.assign(n, std::numeric_limits<double>::infinity());
  bodies.assign(n, KERF_NO_BODY);
  faces.assign(n, KERF_NO_FACE);
  pieces.assign(n, 0);
  for (auto* vectors : {&barycentrics, &positions, &normals}) vectors->assign(n, Vec3(0));
  materials.assign(n, 0);
  is_cut.assign(n, 0);
  (void)for_each_range(n, kQueriesPerBatch, nullptr, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const Hit& hit = hits[i];
      if (!hit.body.valid()) continue;
      const Body& body = world.body(hit.body);
      const Triangle t = body.mesh.triangle(hit.face);
      const Vec3 normal = unit_normal(t);
      distances[i] = hit.distance;
      bodies[i] = to_api(hit.body);
      faces[i] = hit.face.index;
      pieces[i] = body.mesh.data(hit.face).piece;
      barycentrics[i] = kerf::barycentrics(t, normal, hit.point);
      positions[i] = body.placement.to_world(hit.point);
      normals[i] = body.placement.orientation * normal;
      materials[i] = body.mesh.data(hit.face).material;
      is_cut[i] = body.walls.contain(body.mesh, hit.face);
    }
  });
}

kerf_hits HitArrays::view() const {
  kerf_hits hits{};
  hits.count = distances.size();
  hits.offset_count = offsets.size();
  hits.offsets = offsets.data();
  hits.distances = distances.data();
  hits.bodies = bodies.data();
  hits.faces = faces.data();
  hits.pieces = pieces.data();
  hits.barycentrics = numbers_of(barycentrics);
  hits.positions = numbers_of(positions);
  hits.normals = numbers_of(normals);
  hits.materials = materials.data();
  hits.is_cut = is_cut.data();
  return hits;
}

// Gives the arrays of a query to the caller.
void hand_over(std::unique_ptr<HitArrays> arrays, kerf_hits& out) {
  kerf_hits hits = arrays->view();
  hits.owner = arrays.release();
  write_struct(hits, out);
}

using Find = std::function<Status(const World& world, const Progress& progress, HitArrays& arrays)>;

// Runs a query of a world and gives its hits to the caller.
kerf_result query(const kerf_world* world, const kerf_call_options* options, kerf_hits* out,
                  const Find& find) {
  if (out == nullptr) return set_error(KERF_INVALID_ARGUMENT, "out: must not be null");
  return read_world(world, options, [&](const Document& document, const Progress& progress) -> Status {
    if (const Status valid = check_size(*out, "out"); !valid) return valid;
    if (out->size < offsetof(kerf_hits, distances))
      return bad_input("out: its size must be that of kerf_hits");
    auto arrays = std::make_unique<HitArrays>();
    if (const Status found = find(document.world(), progress, *arrays); !found) return found;
    hand_over(std::move(arrays), *out);
    return Done{};
  });
}

// Finds one hit of each of n queries in parallel.
template <typename One>
Status find_one_each(const World& world, size_t n, const Progress& progress, HitArrays& arrays, One one) {
  std::vector<Hit> hits(n);
  const bool done = for_each_range(n, kQueriesPerBatch, &progress, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) hits[i] = one(i);
  });
  if (!done) return cancelled();
  arrays.fill(world, hits);
  return Done{};
}

Status find_all(const World& world, const Rays& rays, const Progress& progress, HitArrays& arrays) {
  const std::vector<BodyId> ids = cuttable(world);
  std::vector<std::vector<Hit>> hits(rays.count);
  const bool done = for_each_range(rays.count, kQueriesPerBatch, &progress, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) append_all(world, ids, rays.pose(i), rays.range, hits[i]);
  });
  if (!done) return cancelled();
  std::vector<Hit> all;
  arrays.offsets.push_back(0);
  for (const std::vector<Hit>& of_ray : hits) {
    all.insert(all.end(), of_ray.begin(), of_ray.end());
    arrays.offsets.push_back(all.size());
  }
  arrays.fill(world, all);
  return Done{};
}

// A box in the world.
struct QueryBox {
  Vec3 low, high, centre, half;

  // Returns true if the box meets or touches a triangle, by the 13 axes that can separate them (T.
  // Akenine-Moeller: Fast 3D triangle-box overlap testing, 2001).
  bool meets(const Triangle& world) const;
};

bool QueryBox::meets(const Triangle& world) const {
  for (int k = 0; k < 3; ++k) {
    const auto [least, most] = std::minmax({world[0][k], world[1][k], world[2][k]});
    if (least > high[k] || most < low[k]) return false;
  }
  constexpr double kRounding = 1e-15;  // of the differences, relative to the coordinates
  const Vec3 slack = kRounding * (glm::abs(centre) + half);
  const Triangle t{world[0] - centre, world[1] - centre, world[2] - centre};
  const auto separates = [&](const Vec3& axis) {
    const double reach = glm::dot(half + slack, glm::abs(axis));
    const auto [least, most] = std::minmax({glm::dot(axis, t[0]), glm::dot(axis, t[1]), glm::dot(axis, t[2])});
    return least > reach || most < -reach;
  };
  if (separates(glm::cross(t[1] - t[0], t[2] - t[0]))) return false;
  for (int k = 0; k < 3; ++k) {
    Vec3 axis(0);
    axis[k] = 1;
    for (size_t i = 0; i < 3; ++i) {
      if (separates(glm::cross(axis, t[(i + 1) % 3] - t[i]))) return false;
    }
  }
  return true;
}

Result<QueryBox> query_box(const double min[3], const double max[3]) {
  constexpr double kMax = 1e150;  // m, as of meshes
  if (min == nullptr || max == nullptr) return bad_input("min and max: must not be null");
  for (int k = 0; k < 3; ++k) {
    if (!(std::abs(min[k]) <= kMax && std::abs(max[k]) <= kMax && min[k] <= max[k]))
      return bad_input("min and max: must be corners in metres, -1e150 <= min <= max <= 1e150");
  }
  const Vec3 low = vector(min, 0), high = vector(max, 0);
  return QueryBox{low, high, 0.5 * (low + high), 0.5 * (high - low)};
}

void append_in_box(const World& world, BodyId id, const QueryBox& box, std::vector<Hit>& out) {
  constexpr double kRounding = 1e-12;  // of the distances, relative to the coordinates
  const Body& body = world.body(id);
  const Vec3 centre = body.placement.to_body(box.centre);
  const double radius = glm::length(box.half);
  std::vector<PointOnFace> near;
  body.tree.points_within(body.mesh, centre, radius + kRounding * (radius + glm::length(box.centre)), near);
  std::sort(near.begin(), near.end(),
            [](const PointOnFace& a, const PointOnFace& b) { return a.face < b.face; });
  for (const PointOnFace& point : near) {
    Triangle t = body.mesh.triangle(point.face);
    for (Vec3& corner : t) corner = body.placement.to_world(corner);
    if (box.meets(t)) out.push_back({std::sqrt(point.distance2), id, point.face, point.point});
  }
}

}  // namespace

Vec3 unit_normal(const Triangle& t) {
  const Vec3 across = glm::cross(t[1] - t[0], t[2] - t[0]);
  const double length = glm::length(across);
  return length > 0 && std::isfinite(length) ? across / length : Vec3(0);
}

}  // namespace kerf

kerf_result kerf_world_nearest_hits(const kerf_world* world, const double* origins, const double* directions,
                                    size_t n, const double range[2], const kerf_call_options* options,
                                    kerf_hits* out) {
  return kerf::query(
      world, options, out,
      [&](const kerf::World& in, const kerf::Progress& progress, kerf::HitArrays& arrays) -> kerf::Status {
        const auto rays = kerf::rays_of(origins, directions, n, range);
        if (!rays) return rays.error();
        const std::vector<kerf::BodyId> ids = kerf::cuttable(in);
        return kerf::find_one_each(in, n, progress, arrays, [&](size_t i) {
          return kerf::nearest(in, ids, rays->pose(i), rays->range);
        });
      });
}

kerf_result kerf_world_all_hits(const kerf_world* world, const double* origins, const double* directions,
                                size_t n, const double range[2], const kerf_call_options* options,
                                kerf_hits* out) {
  return kerf::query(
      world, options, out,
      [&](const kerf::World& in, const kerf::Progress& progress, kerf::HitArrays& arrays) -> kerf::Status {
        const auto rays = kerf::rays_of(origins, directions, n, range);
        if (!rays) return rays.error();
        return kerf::find_all(in, *rays, progress, arrays);
      });
}

kerf_result kerf_world_closest_points(const kerf_world* world, const double* points, size_t n,
                                      double max_distance, const kerf_call_options* options, kerf_hits* out) {
  return kerf::query(
      world, options, out,
      [&](const kerf::World& in, const kerf::Progress& progress, kerf::HitArrays& arrays) -> kerf::Status {
        if (n > 0 && points == nullptr) return kerf::bad_input("points: must not be null");
        if (!(max_distance >= 0))
          return kerf::bad_input("max_distance: must be a length in metres >= 0, or infinity");
        if (const kerf::Status finite = kerf::check_finite(points, n, "points"); !finite) return finite;
        const std::vector<kerf::BodyId> ids = kerf::cuttable(in);
        return kerf::find_one_each(in, n, progress, arrays, [&](size_t i) {
          return kerf::closest(in, ids, kerf::vector(points, i), max_distance);
        });
      });
}

kerf_result kerf_world_faces_in_box(const kerf_world* world, const double min[3], const double max[3],
                                    const kerf_call_options* options, kerf_hits* out) {
  return kerf::query(
      world, options, out,
      [&](const kerf::World& in, const kerf::Progress&, kerf::HitArrays& arrays) -> kerf::Status {
        const auto box = kerf::query_box(min, max);
        if (!box) return box.error();
        std::vector<kerf::Hit> hits;
        for (const kerf::BodyId id : kerf::cuttable(in)) kerf::append_in_box(in, id, *box, hits);
        arrays.fill(in, hits);
        return kerf::Done{};
      });
}

void kerf_hits_free(kerf_hits* hits) {
  if (hits == nullptr) return;
  const auto own = kerf::read_struct(hits, KERF_HITS_INIT, "hits");
  if (!own) return;
  delete static_cast<kerf::HitArrays*>(own->owner);
  kerf::write_struct(kerf_hits{}, *hits);
}
