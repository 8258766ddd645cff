#include "ui/render/bodies/pick.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "core/base/assert.h"
#include "core/base/geometry.h"
#include "ui/render/bodies/piece_looks.h"

namespace kerf {

namespace {

constexpr double kEndless = std::numeric_limits<double>::max();

// Returns the distinct offsets at which pieces of a body are drawn, including zero.
std::vector<Vec3> offsets_of(const BodyLooks& looks) {
  std::vector<Vec3> offsets{Vec3(0)};
  for (const auto& [group, look] : looks.by_group()) {
    if (std::find(offsets.begin(), offsets.end(), look.offset) == offsets.end())
      offsets.push_back(look.offset);
  }
  return offsets;
}

bool shows_front(const Body& body, FaceId f, const Vec3& direction) {
  const Triangle t = body.mesh.triangle(f);
  return glm::dot(glm::cross(t[1] - t[0], t[2] - t[0]), direction) < 0;
}

}  // namespace

std::optional<Pick> pick(const World& world, const ViewOptions& options, const Pose& ray) {
  KERF_ASSERT(is_unit(ray.direction));
  std::optional<Pick> nearest;
  const SectionPlane* section = shown_section(options);
  const Interval seen = section != nullptr ? section->kept_along(ray) : Interval{0, kEndless};
  std::vector<RayHit> hits;
  for (const BodyId id : world.ids()) {
    const Body& body = world.body(id);
    const BodyLooks looks(id, options);
    for (const Vec3& offset : offsets_of(looks)) {
      const Pose through = body.placement.to_body(Pose{ray.origin - offset, ray.direction});
      const double most = nearest ? nearest->length : seen.high;
      hits.clear();
      body.tree.crossings(body.mesh, through, {seen.low, most}, hits);
      for (const RayHit& hit : hits) {
        const PieceLook& look = looks.of(body.mesh, hit.face);
        if (look.hidden || look.offset != offset) continue;
        if (options.cull_backs && !shows_front(body, hit.face, through.direction)) continue;
        if (!nearest || hit.length < nearest->length) nearest = Pick{id, hit.face, hit.length};
        break;
      }
    }
  }
  return nearest;
}

}  // namespace kerf
