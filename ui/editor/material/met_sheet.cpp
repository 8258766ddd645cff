#include "ui/editor/material/met_sheet.h"

#include <algorithm>
#include <cmath>

#include "ui/render/bodies/pick.h"

namespace kerf {

namespace {
constexpr double kLeastCosine = 0.2;
}

std::optional<MetSheet> met_sheet(const World& world, const ViewOptions& options, const Pose& ray) {
  const std::optional<Pick> met = pick(world, options, ray);
  if (!met) return std::nullopt;
  const Body& body = world.body(met->body);
  const Triangle t = body.mesh.triangle(met->face);
  const Vec3 across = glm::cross(t[1] - t[0], t[2] - t[0]);
  const double along = std::abs(glm::dot(across, body.placement.to_body(ray).direction));
  const double cosine = std::max(along / glm::length(across), kLeastCosine);
  return MetSheet{body.sheet, 1 / cosine, met->length};
}

}  // namespace kerf
