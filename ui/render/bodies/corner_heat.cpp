#include "ui/render/bodies/corner_heat.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/packing.hpp>
#include <utility>

#include "core/base/assert.h"
#include "core/mesh/longest_edge.h"
#include "ui/render/bodies/heat_fit.h"

namespace kerf {

namespace {

constexpr double kColdWithin = 0.5;  // K, which nobody sees
// How hot a corner may have been at the outline of what was hot, between the temperatures of the faces there.
constexpr double kAtOutline = 0.25;

// A half float; none is infinite.
uint16_t packed_half(double x) {
  constexpr double kLargest = 65504;
  return glm::packHalf1x16(static_cast<float>(std::clamp(x, -kLargest, kLargest)));
}

CornerTemperature packed(const LocalHeat& heat, double scale) {
  CornerTemperature corner;
  const Vec3 gradient = heat.gradient / (scale * kHeatGradientUnit);
  for (int i = 0; i < 3; ++i) corner.gradient[static_cast<size_t>(i)] = packed_half(gradient[i]);
  if (heat.at >= kAmbient + kColdWithin)
    corner.at = static_cast<uint16_t>(std::min(65535.0, std::round(heat.at / kHeatUnit)));
  return corner;
}

// Faces that were never hot enough to keep their highest temperature tell nothing of it but that: it ends
// between their centroids and those of the others, where it falls to, not where a face begins.
CornerTemperature hottest_at(const Vec3& vertex, std::vector<FaceSample> samples, double scale) {
  const size_t all = samples.size();
  std::erase_if(samples, [](const FaceSample& s) { return s.temperatures[1] <= kAmbient; });
  if (samples.empty()) return {};
  LocalHeat heat = fit_heat(vertex, samples)[1];
  if (samples.size() < all) {
    const auto [least, most] =
        std::ranges::minmax(samples, {}, [](const FaceSample& s) { return s.temperatures[1]; });
    heat.at = std::min(heat.at, glm::mix(least.temperatures[1], most.temperatures[1], kAtOutline));
  }
  return packed(heat, scale);
}

HeatMark mark_at(const Body& body, VertexId v, const std::vector<FaceId>& faces, double scale) {
  std::vector<FaceSample> samples;
  samples.reserve(faces.size());
  double most = 0;
  for (const FaceId f : faces) {
    const Triangle t = body.mesh.triangle(f);
    const double size2 = longest_edge2(t);
    if (size2 == 0) continue;
    const double now = body.heat.temperature(body.mesh, f, body.sheet.substance, body.sheet.thickness);
    const double hottest = body.heat.hottest_of(body.mesh, f);
    samples.push_back({(t[0] + t[1] + t[2]) / 3.0, std::sqrt(size2), {now, hottest}});
    most = std::max({most, now, hottest});
  }
  if (most < kAmbient + kColdWithin) return {};
  const Vec3& at = body.mesh.position(v);
  return {packed(fit_heat(at, samples)[0], scale), hottest_at(at, std::move(samples), scale)};
}

void make_unique(std::vector<VertexId>& corners) {
  std::sort(corners.begin(), corners.end());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
}

}  // namespace

void CornerHeat::add_corners(const Mesh& mesh, FaceId f, std::vector<VertexId>& corners) const {
  const std::array<VertexId, 3> of = mesh.corners(f);
  corners.insert(corners.end(), of.begin(), of.end());
}

// Appends the corners of the faces that have energy, which are also those that may be cold next time.
void CornerHeat::find_hot(const Body& body, std::vector<VertexId>& corners) {
  corners.insert(corners.end(), hot_.begin(), hot_.end());
  hot_.clear();
  warmest_ = kAmbient;
  body.mesh.columns().for_each_set(body.heat.energy, [&](FaceId f) {
    add_corners(body.mesh, f, hot_);
    warmest_ =
        std::max(warmest_, body.heat.temperature(body.mesh, f, body.sheet.substance, body.sheet.thickness));
  });
  make_unique(hot_);
  corners.insert(corners.end(), hot_.begin(), hot_.end());
}

// Appends the corners of the faces whose highest temperature is another one than at the last update.
void CornerHeat::find_tinted(const Body& body, std::vector<VertexId>& corners) {
  const FaceColumns& columns = body.mesh.columns();
  const auto note = [&](FaceId f, float hottest) {
    if (seen_.size() <= f.index) seen_.resize(f.index + 1, 0);
    if (std::exchange(seen_[f.index], hottest) == hottest) return;
    if (body.mesh.is_live(f)) add_corners(body.mesh, f, corners);
  };
  for (const FaceId f : tinted_) note(f, columns.get(body.heat.hottest, f));
  tinted_.clear();
  columns.for_each_set(body.heat.hottest, [&](FaceId f) {
    tinted_.push_back(f);
    note(f, columns.get(body.heat.hottest, f));
  });
}

void CornerHeat::update(const Body& body, double scale, std::vector<VertexId> changed,
                        std::vector<FaceId>& affected) {
  KERF_ASSERT(scale > 0);
  find_hot(body, changed);
  find_tinted(body, changed);
  make_unique(changed);
  walls_ = body.walls;
  Mesh::Star star;
  for (const VertexId v : changed) {
    if (v.index >= body.mesh.vertex_slots()) continue;
    body.mesh.star(v, star);
    const auto walls = std::stable_partition(star.faces.begin(), star.faces.end(),
                                             [&](FaceId f) { return !walls_.contain(body.mesh, f); });
    const std::vector<FaceId> surface(star.faces.begin(), walls), beside(walls, star.faces.end());
    set_mark(marks_, v, mark_at(body, v, surface, scale), surface, affected);
    HeatMark of_wall = mark_at(body, v, beside, scale);
    of_wall.now.gradient = of_wall.hottest.gradient = {};
    set_mark(wall_marks_, v, of_wall, beside, affected);
  }
}

void CornerHeat::set_mark(std::vector<HeatMark>& marks, VertexId v, const HeatMark& mark,
                          const std::vector<FaceId>& faces, std::vector<FaceId>& affected) const {
  if (marks.size() <= v.index && mark == HeatMark{}) return;
  if (marks.size() <= v.index) marks.resize(v.index + 1);
  if (std::exchange(marks[v.index], mark) == mark) return;
  affected.insert(affected.end(), faces.begin(), faces.end());
}

std::array<HeatMark, 3> CornerHeat::of(const Mesh& mesh, FaceId f) const {
  const std::vector<HeatMark>& known = walls_.contain(mesh, f) ? wall_marks_ : marks_;
  std::array<HeatMark, 3> marks;
  const std::array<VertexId, 3> corners = mesh.corners(f);
  for (size_t i = 0; i < 3; ++i) {
    if (corners[i].index < known.size()) marks[i] = known[corners[i].index];
  }
  return marks;
}

}  // namespace kerf
