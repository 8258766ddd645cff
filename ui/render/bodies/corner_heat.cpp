#include "ui/render/bodies/corner_heat.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/glm.hpp>
#include <glm/gtc/packing.hpp>
#include <utility>

#include "core/base/assert.h"
#include "core/base/parallel.h"
#include "core/mesh/refinement.h"

namespace kerf {

namespace {

// Fraction of the matrix's trace added to its diagonal, so that rounding decides nothing in undetermined
// directions.
constexpr double kOpenShare = 1e-4;
// Maximum deviation of the vertex beyond the temperatures of the faces, relative to their range.
constexpr double kMaxBeyond = 0.5;

double weight_of(const FaceSample& sample) {
  const double size2 = sample.size * sample.size;
  return 1 / (size2 * size2);
}

struct Mean {
  double weight = 0;
  Vec3 offset{0};  // from the vertex
  std::array<double, 2> temperatures{};
};

Mean mean_of(const Vec3& vertex, std::span<const FaceSample> samples) {
  Mean mean;
  for (const FaceSample& sample : samples) {
    const double weight = weight_of(sample);
    mean.weight += weight;
    mean.offset += weight * (sample.centroid - vertex);
    for (size_t i = 0; i < 2; ++i) mean.temperatures[i] += weight * sample.temperatures[i];
  }
  mean.offset /= mean.weight;
  for (double& temperature : mean.temperatures) temperature /= mean.weight;
  return mean;
}

}  // namespace

std::array<LocalHeat, 2> fit_heat(const Vec3& vertex, std::span<const FaceSample> samples) {
  KERF_ASSERT(!samples.empty() && std::all_of(samples.begin(), samples.end(),
                                              [](const FaceSample& sample) { return sample.size > 0; }));
  const Mean mean = mean_of(vertex, samples);
  glm::dmat3 spread(0);
  std::array<Vec3, 2> moments{Vec3(0), Vec3(0)};
  std::array<double, 2> least = samples[0].temperatures, most = least;
  for (const FaceSample& sample : samples) {
    const Vec3 offset = sample.centroid - vertex - mean.offset;
    const Vec3 weighted = weight_of(sample) * offset;
    spread += glm::outerProduct(offset, weighted);
    for (size_t i = 0; i < 2; ++i) {
      moments[i] += weighted * (sample.temperatures[i] - mean.temperatures[i]);
      least[i] = std::min(least[i], sample.temperatures[i]);
      most[i] = std::max(most[i], sample.temperatures[i]);
    }
  }
  const double trace = spread[0][0] + spread[1][1] + spread[2][2];
  glm::dmat3 inverse(0);
  if (trace > 0) inverse = glm::inverse(spread / trace + glm::dmat3(kOpenShare)) / trace;
  std::array<LocalHeat, 2> fits;
  for (size_t i = 0; i < 2; ++i) {
    const Vec3 gradient = inverse * moments[i];
    const double beyond = kMaxBeyond * (most[i] - least[i]);
    fits[i] = {std::clamp(mean.temperatures[i] - glm::dot(gradient, mean.offset), least[i] - beyond,
                          most[i] + beyond),
               gradient};
  }
  return fits;
}

namespace {

constexpr double kColdWithin = 0.5;  // K, invisible
constexpr double kUnknown = -1;      // J, which no face has
// The maximum temperature of a corner at the outline of the heated area, between the temperatures of its
// faces.
constexpr double kAtOutline = 0.25;

// Packs a half float; never infinite.
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

// Faces that were never hot enough to keep their maximum temperature only bound it: the heated area ends
// between their centroids and those of the others, where the temperature falls to the bound, not at the
// edge of a face. Removes their samples.
CornerTemperature hottest_at(const Vec3& vertex, std::vector<FaceSample>& samples, double scale) {
  const size_t cold =
      std::erase_if(samples, [](const FaceSample& s) { return s.temperatures[1] <= kAmbient; });
  if (samples.empty()) return {};
  LocalHeat heat = fit_heat(vertex, samples)[1];
  if (cold > 0) {
    const auto [least, most] =
        std::ranges::minmax(samples, {}, [](const FaceSample& s) { return s.temperatures[1]; });
    heat.at = std::min(heat.at, glm::mix(least.temperatures[1], most.temperatures[1], kAtOutline));
  }
  return packed(heat, scale);
}

}  // namespace

// Computes the marks of vertices from the known temperatures of their faces.
class CornerHeat::Fitter {
 public:
  Fitter(const CornerHeat& heat, const Body& body, double scale) : heat_(heat), body_(body), scale_(scale) {}

  // Appends the changed marks at a vertex of the mesh.
  void fit(VertexId v, NewMarks& found) {
    body_.mesh.star(v, star_);
    std::vector<FaceId>& faces = star_.faces;
    const auto is_wall = [&](FaceId f) { return heat_.walls_.contain(body_.mesh, f); };
    auto walls = faces.end();
    if (std::ranges::any_of(faces, is_wall))
      walls = std::stable_partition(faces.begin(), faces.end(), std::not_fn(is_wall));
    const std::span<const FaceId> surface(faces.begin(), walls), beside(walls, faces.end());
    note(heat_.marks_, v, mark_at(v, surface), surface, found.of_surface, found.affected);
    HeatMark of_wall = mark_at(v, beside);
    of_wall.now.gradient = of_wall.hottest.gradient = {};
    note(heat_.wall_marks_, v, of_wall, beside, found.of_walls, found.affected);
  }

 private:
  HeatMark mark_at(VertexId v, std::span<const FaceId> faces) {
    samples_.clear();
    double most = 0;
    for (const FaceId f : faces) {
      const Triangle t = body_.mesh.triangle(f);
      const double size2 = longest_edge2(t);
      if (size2 == 0) continue;
      const Known known = heat_.known_.get(f.index);
      samples_.push_back({(t[0] + t[1] + t[2]) / 3.0, std::sqrt(size2), {known.now, known.hottest}});
      most = std::max({most, known.now, known.hottest});
    }
    if (most < kAmbient + kColdWithin) return {};
    const Vec3& at = body_.mesh.position(v);
    const CornerTemperature now = packed(fit_heat(at, samples_)[0], scale_);
    return {now, hottest_at(at, samples_, scale_)};
  }

  static void note(const std::vector<HeatMark>& marks, VertexId v, const HeatMark& mark,
                   std::span<const FaceId> faces, std::vector<std::pair<VertexId, HeatMark>>& found,
                   std::vector<FaceId>& affected) {
    if (mark == (v.index < marks.size() ? marks[v.index] : HeatMark{})) return;
    found.emplace_back(v, mark);
    affected.insert(affected.end(), faces.begin(), faces.end());
  }

  const CornerHeat& heat_;
  const Body& body_;
  double scale_;
  Mesh::Star star_;
  std::vector<FaceSample> samples_;
};

// Returns true if it was not in the list.
bool CornerHeat::list_corner(VertexId v) {
  if (is_listed_.size() <= v.index) is_listed_.resize(v.index + 1, 0);
  if (std::exchange(is_listed_[v.index], 1) != 0) return false;
  to_fit_.push_back(v);
  return true;
}

void CornerHeat::list_corners(const Mesh& mesh, FaceId f) {
  for (const VertexId v : mesh.corners(f)) list_corner(v);
}

// A face with other corners has another temperature with the same energy.
void CornerHeat::forget_temperatures(const Body& body, std::span<const VertexId> changed) {
  Mesh::Star star;
  for (const VertexId v : changed) {
    if (v.index >= body.mesh.vertex_slots() || !list_corner(v)) continue;
    body.mesh.star(v, star);
    for (const FaceId f : star.faces) {
      if (known_.get(f.index).energy != 0) known_.at(f.index).energy = kUnknown;
    }
  }
}

// Lists the corners of faces whose energy has changed since the last update.
void CornerHeat::find_reheated(const Body& body) {
  const FaceColumns& columns = body.mesh.columns();
  const auto note = [&](FaceId f) {
    const double energy = columns.get(body.heat.energy, f);
    if (known_.get(f.index).energy != energy) {
      Known& known = known_.at(f.index);
      known.energy = energy;
      const bool lives = body.mesh.is_live(f);
      known.now = lives ? body.heat.temperature(body.mesh, f, sheet_.substance, sheet_.thickness) : kAmbient;
      if (lives) list_corners(body.mesh, f);
    }
    warmest_ = std::max(warmest_, known_.get(f.index).now);
  };
  warmest_ = kAmbient;
  for (const FaceId f : std::exchange(hot_, {})) note(f);
  columns.for_each_set(body.heat.energy, [&](FaceId f) {
    hot_.push_back(f);
    note(f);
  });
}

// Lists the corners of faces whose maximum temperature has changed since the last update.
void CornerHeat::find_tinted(const Body& body) {
  const auto note = [&](FaceId f) {
    const double hottest = body.heat.hottest_of(body.mesh, f);
    if (known_.get(f.index).hottest == hottest) return;
    known_.at(f.index).hottest = hottest;
    if (body.mesh.is_live(f)) list_corners(body.mesh, f);
  };
  for (const FaceId f : std::exchange(tinted_, {})) note(f);
  body.mesh.columns().for_each_set(body.heat.hottest, [&](FaceId f) {
    tinted_.push_back(f);
    note(f);
  });
}

void CornerHeat::update(const Body& body, double scale, std::span<const VertexId> changed,
                        std::vector<FaceId>& affected) {
  KERF_ASSERT(scale > 0);
  constexpr size_t kTogether = 1024;  // vertices
  if (sheet_ != body.sheet) {
    for (const FaceId f : hot_) known_.at(f.index).energy = kUnknown;
  }
  sheet_ = body.sheet;
  walls_ = body.walls;
  forget_temperatures(body, changed);
  find_reheated(body);
  find_tinted(body);
  std::vector<NewMarks> found(range_count(to_fit_.size(), kTogether));
  for_each_range(to_fit_.size(), kTogether, [&](size_t begin, size_t end) {
    Fitter fitter(*this, body, scale);
    for (size_t i = begin; i < end; ++i) fitter.fit(to_fit_[i], found[begin / kTogether]);
  });
  for (const NewMarks& part : found) {
    set_marks(marks_, part.of_surface);
    set_marks(wall_marks_, part.of_walls);
    affected.insert(affected.end(), part.affected.begin(), part.affected.end());
  }
  for (const VertexId v : to_fit_) is_listed_[v.index] = 0;
  to_fit_.clear();
}

void CornerHeat::set_marks(std::vector<HeatMark>& marks,
                           std::span<const std::pair<VertexId, HeatMark>> found) {
  for (const auto& [v, mark] : found) {
    if (marks.size() <= v.index) marks.resize(v.index + 1);
    marks[v.index] = mark;
  }
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
