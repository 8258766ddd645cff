#include <cmath>
#include <limits>
#include <memory>

#include "core/api/api_internal.h"
#include "core/base/parallel.h"
#include "core/document/stroke_path.h"

namespace kerf {

namespace {

constexpr size_t kRaysPerBatch = 1024;

// Rays as given by the caller.
struct Rays {
  const double *origins, *directions;
  size_t count;
  Interval range;

  Vec3 vector(const double* of, size_t i) const { return {of[3 * i], of[3 * i + 1], of[3 * i + 2]}; }
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
  const auto is_finite = [](const Vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
  };
  for (size_t i = 0; i < n; ++i) {
    if (!is_finite(rays.vector(origins, i)))
      return bad_input("origins[" + std::to_string(i) + "] is not finite");
    const Vec3 direction = rays.vector(directions, i);
    if (!is_finite(direction) || direction == Vec3(0))
      return bad_input("directions[" + std::to_string(i) + "] is zero or not finite");
  }
  return rays;
}

// A crossing of a ray, in any body.
struct Hit {
  double distance = std::numeric_limits<double>::infinity();
  uint32_t body = kNoIndex, face = kNoIndex;
};

Hit nearest(const World& world, const std::vector<BodyId>& ids, const Pose& ray, const Interval& range) {
  Hit first;
  for (uint32_t b = 0; b < ids.size(); ++b) {
    const Body& body = world.body(ids[b]);
    const auto hit = body.tree.nearest(body.mesh, body.placement.to_body(ray), range);
    if (hit && hit->length < first.distance) first = {hit->length, b, hit->face.index};
  }
  return first;
}

void append_all(const World& world, const std::vector<BodyId>& ids, const Pose& ray, const Interval& range,
                std::vector<Hit>& out) {
  std::vector<RayHit> found;
  for (uint32_t b = 0; b < ids.size(); ++b) {
    const Body& body = world.body(ids[b]);
    found.clear();
    body.tree.crossings(body.mesh, body.placement.to_body(ray), range, found);
    for (const RayHit& hit : found) out.push_back({hit.length, b, hit.face.index});
  }
  std::stable_sort(out.begin(), out.end(),
                   [](const Hit& a, const Hit& b) { return a.distance < b.distance; });
}

std::vector<BodyId> ids_of(const World& world) {
  const auto ids = world.ids();
  return {ids.begin(), ids.end()};
}

// Owner of the arrays of a kerf_hits.
struct HitArrays {
  std::vector<size_t> offsets{0};
  std::vector<double> distances;
  std::vector<uint32_t> bodies, faces;
};

Status find_all(const World& world, const Rays& rays, const Progress& progress, HitArrays& out) {
  const std::vector<BodyId> ids = ids_of(world);
  std::vector<std::vector<Hit>> hits(rays.count);
  const bool done = for_each_range(rays.count, kRaysPerBatch, &progress, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) append_all(world, ids, rays.pose(i), rays.range, hits[i]);
  });
  if (!done) return cancelled();
  for (const std::vector<Hit>& of_ray : hits) {
    for (const Hit& hit : of_ray) {
      out.distances.push_back(hit.distance);
      out.bodies.push_back(hit.body);
      out.faces.push_back(hit.face);
    }
    out.offsets.push_back(out.distances.size());
  }
  return Done{};
}

}  // namespace
}  // namespace kerf

kerf_result kerf_world_nearest_hits(const kerf_world* world, const double* origins, const double* directions,
                                    size_t n, const double range[2], const kerf_call_options* options,
                                    double* distances, uint32_t* bodies, uint32_t* faces) {
  return kerf::read_world(
      world, options, [&](const kerf::Document& document, const kerf::Progress& progress) -> kerf::Status {
        const auto rays = kerf::rays_of(origins, directions, n, range);
        if (!rays) return rays.error();
        const auto ids = kerf::ids_of(document.world());
        std::vector<kerf::Hit> hits(n);
        const bool done =
            kerf::for_each_range(n, kerf::kRaysPerBatch, &progress, [&](size_t begin, size_t end) {
              for (size_t i = begin; i < end; ++i)
                hits[i] = kerf::nearest(document.world(), ids, rays->pose(i), rays->range);
            });
        if (!done) return kerf::cancelled();
        for (size_t i = 0; i < n; ++i) {
          if (distances != nullptr) distances[i] = hits[i].distance;
          if (bodies != nullptr) bodies[i] = hits[i].body;
          if (faces != nullptr) faces[i] = hits[i].face;
        }
        return kerf::Done{};
      });
}

kerf_result kerf_world_all_hits(const kerf_world* world, const double* origins, const double* directions,
                                size_t n, const double range[2], const kerf_call_options* options,
                                kerf_hits* out) {
  if (out == nullptr) return kerf::set_error(KERF_INVALID_ARGUMENT, "out: must not be null");
  return kerf::read_world(
      world, options, [&](const kerf::Document& document, const kerf::Progress& progress) -> kerf::Status {
        const auto rays = kerf::rays_of(origins, directions, n, range);
        if (!rays) return rays.error();
        auto arrays = std::make_unique<kerf::HitArrays>();
        const kerf::Status found = kerf::find_all(document.world(), *rays, progress, *arrays);
        if (!found) return found;
        *out = {arrays->distances.size(), arrays->offsets.data(), arrays->distances.data(),
                arrays->bodies.data(),    arrays->faces.data(),   nullptr};
        out->owner = arrays.release();
        return kerf::Done{};
      });
}

void kerf_hits_free(kerf_hits* hits) {
  if (hits == nullptr) return;
  delete static_cast<kerf::HitArrays*>(hits->owner);
  *hits = kerf_hits{};
}
