#include "core/mesh/remesh/collapser_internal.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include "core/base/assert.h"
#include "core/base/tolerances.h"
#include "core/mesh/measures.h"

namespace kerf {

namespace {

std::array<Vec3, 4> middles_of_quarters(const Triangle& t) {
  const Vec3 middle = (t[0] + t[1] + t[2]) / 3.0;
  return {0.5 * (middle + t[0]), 0.5 * (middle + t[1]), 0.5 * (middle + t[2]), middle};
}

uint32_t nearest_to(const Vec3& p, std::span<const FollowedFaces::Changed> changed) {
  const FollowedFaces::Changed* nearest = &changed.front();
  double least = squared_distance(p, nearest->corners);
  for (const FollowedFaces::Changed& face : changed.subspan(1)) {
    const double distance2 = squared_distance(p, face.corners);
    if (distance2 >= least) continue;
    least = distance2;
    nearest = &face;
  }
  return nearest->face;
}

std::vector<Vec3> points_of(const Mesh& mesh, const FlatSheets& sheets) {
  std::vector<Vec3> points(sheets.vertices.size());
  for (uint32_t v = 0; v < points.size(); ++v) points[v] = sheets.point(mesh, v);
  return points;
}

// If the mean square of the distance from the planes is this many times the bound, the samples are not
// tested: few would be near, and testing takes half of the time.
constexpr double kMaxOverBound2 = 4;

// Progress reports of a whole simplification, in addition to one per round.
constexpr size_t kReports = 64;

}  // namespace

FollowedFaces::FollowedFaces(const Mesh& mesh, const FloatFrame& frame, std::span<const FaceId> numbers,
                             std::span<const FaceId> faces)
    : faces_(faces.begin(), faces.end()) {
  if (faces_.empty()) return;
  lying_.assign(numbers.size(), kNone);
  for (const FaceId f : faces_) {
    const auto at = std::lower_bound(numbers.begin(), numbers.end(), f);
    KERF_ASSERT(at != numbers.end() && *at == f);
    uint32_t& lying = lying_[static_cast<size_t>(at - numbers.begin())];
    Triangle corners = mesh.triangle(f);
    for (Vec3& p : corners) p = frame.scaled(p);
    for (const Vec3& middle : middles_of_quarters(corners)) {
      next_.push_back(std::exchange(lying, static_cast<uint32_t>(next_.size())));
      middles_.push_back(middle);
    }
  }
}

void FollowedFaces::hand_on(std::span<const uint32_t> before, std::span<const Changed> changed) {
  KERF_ASSERT(!before.empty() && !changed.empty());
  std::vector<uint32_t> quarters;
  for (const uint32_t f : before) {
    for (uint32_t q = std::exchange(lying_[f], kNone); q != kNone; q = next_[q]) quarters.push_back(q);
  }
  for (const uint32_t q : quarters) {
    const uint32_t f = nearest_to(middles_[q], changed);
    next_[q] = std::exchange(lying_[f], q);
  }
}

std::vector<FollowedFace> FollowedFaces::places(std::span<const FaceId> numbers) const {
  std::vector<FollowedFace> places;
  for (const FaceId f : faces_) places.push_back({f, {}});
  for (size_t f = 0; f < lying_.size(); ++f) {
    for (uint32_t q = lying_[f]; q != kNone; q = next_[q]) places[q / 4].quarters[q % 4] = numbers[f];
  }
  return places;
}

SurfaceSamples::SurfaceSamples(const FlatSurface& surface) : first_(surface.faces(), kNoIndex) {
  for (uint32_t f = 0; f < surface.faces(); ++f) {
    if (!surface.has(f)) continue;
    const auto& [a, b, c] = surface.corners(f);
    add(f, (surface.point(a) + surface.point(b) + surface.point(c)) / 3.0);
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
      if (from < to)  // on boundaries, which stay, the sample is optional
        add(f, 0.5 * (surface.point(from) + surface.point(to)));
    }
  }
}

void SurfaceSamples::add(uint32_t face, const Vec3& p) {
  next_.push_back(std::exchange(first_[face], static_cast<uint32_t>(points_.size())));
  points_.push_back(p);
}

bool SurfaceSamples::are_near(std::span<const uint32_t> before, const Vec3& removed,
                              std::span<const FollowedFaces::Changed> changed) const {
  // Starts with the face that was near enough to the previous sample.
  size_t last = 0;
  const auto near = [&](const Vec3& p) {
    for (size_t tried = 0; tried < changed.size(); ++tried) {
      if (squared_distance(p, changed[last].corners) <= most2_) return true;
      last = last + 1 == changed.size() ? 0 : last + 1;
    }
    return false;
  };
  if (!near(removed)) return false;
  for (const uint32_t f : before) {
    for (uint32_t s = first_[f]; s != kNoIndex; s = next_[s]) {
      if (!near(points_[s])) return false;
    }
  }
  return true;
}

void SurfaceSamples::hand_on(std::span<const uint32_t> before, const Vec3& removed,
                             std::span<const FollowedFaces::Changed> changed) {
  KERF_ASSERT(!changed.empty());
  const auto nearest = [&](const Vec3& p) {
    return std::min_element(changed.begin(), changed.end(),
                            [&](const auto& a, const auto& b) {
                              return squared_distance(p, a.corners) < squared_distance(p, b.corners);
                            })
        ->face;
  };
  std::vector<uint32_t> moved;
  for (const uint32_t f : before) {
    for (uint32_t s = std::exchange(first_[f], kNoIndex); s != kNoIndex; s = next_[s]) moved.push_back(s);
  }
  for (const uint32_t s : moved) next_[s] = std::exchange(first_[nearest(points_[s])], s);
  add(nearest(removed), removed);
}

namespace {

double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

// Twice the signed area, 0 if it is within rounding of 0: of the UVs and of products of them.
double signed_area(const FaceUvs& t) {
  const glm::dvec2 u = t[1] - t[0], w = t[2] - t[0];
  const auto largest = [](const glm::dvec2& p) { return std::max(std::abs(p.x), std::abs(p.y)); };
  const double area = cross(u, w), size = std::max({largest(t[0]), largest(t[1]), largest(t[2])});
  return std::abs(area) <= kSideRoundings * size * std::max(largest(u), largest(w)) ? 0 : area;
}

// Returns true if all of `other` lies beyond a side of a triangle with this sign, or on it up to rounding.
bool separates(const FaceUvs& t, double sign, const FaceUvs& other) {
  for (size_t i = 0; i < 3; ++i) {
    const glm::dvec2 side = sign * (t[(i + 1) % 3] - t[i]);
    double highest = -std::numeric_limits<double>::infinity(), extent = glm::dot(side, side);
    for (const glm::dvec2& p : other) {
      highest = std::max(highest, cross(side, p - t[i]));
      extent = std::max(extent, glm::dot(p - t[i], p - t[i]));
    }
    if (highest <= kOnLoadedSide * extent) return true;
  }
  return false;
}

// Returns true if the interiors of two triangles overlap. Precondition: both have an area.
bool overlap(const FaceUvs& a, const FaceUvs& b) {
  const auto sign = [](const FaceUvs& t) { return signed_area(t) < 0 ? -1.0 : 1.0; };
  return !separates(a, sign(a), b) && !separates(b, sign(b), a);
}

bool is_changed(const FlatSurface::Opposite& side, uint32_t to) { return side.from != to && side.to != to; }

}  // namespace

UvStretch::UvStretch(const FlatSheets& sheets, const FlatSurface& surface)
    : sheets_(sheets), surface_(surface) {
  for (const std::vector<FaceUvs>& original : sheets.uv_sets) {
    Set& set = sets_.emplace_back(Set{original, original, {}});
    set.overlaps.resize(original.size());
    for (uint32_t f = 0; f < original.size(); ++f) {
      const auto& [a, b, c] = sheets.corners[f];
      const Vec3 across =
          glm::cross(surface.point(b) - surface.point(a), surface.point(c) - surface.point(a));
      if (has_uvs(original[f]) && signed_area(original[f]) != 0 && across != Vec3(0))
        set.overlaps[f].push_back(f);
    }
  }
}

size_t UvStretch::corner_of(uint32_t f, uint32_t v) const {
  const auto& corners = surface_.corners(f);
  return corners[0] == v ? 0 : corners[1] == v ? 1 : 2;
}

// Returns the UVs of a face after its corner at a vertex has moved.
FaceUvs UvStretch::changed(const Set& set, uint32_t f, uint32_t v, const glm::dvec2& to) const {
  FaceUvs uvs = set.uvs[f];
  uvs[corner_of(f, v)] = to;
  return uvs;
}

// Returns the UV of a vertex in the chart of a ring.
glm::dvec2 UvStretch::target(const Set& set, uint32_t to, const Ring& ring) const {
  const auto shared =
      std::ranges::find_if(ring.sides, [&](const auto& side) { return !is_changed(side, to); });
  KERF_ASSERT(shared != ring.sides.end());
  return set.uvs[shared->face][corner_of(shared->face, to)];
}

// Collects in around_ the original faces that the faces of a ring overlap, each once.
void UvStretch::collect_overlaps(const Set& set, const Ring& ring) {
  around_.clear();
  for (const FlatSurface::Opposite& side : ring.sides)
    around_.insert(around_.end(), set.overlaps[side.face].begin(), set.overlaps[side.face].end());
  std::ranges::sort(around_);
  around_.erase(std::unique(around_.begin(), around_.end()), around_.end());
}

// Compares the metrics of both faces in coordinates along two sides of the original one, in which that metric
// is A and that of the current face B. The eigenvalues of A^-1 B are the squared singular values.
bool UvStretch::is_within_bound(const Set& set, uint32_t original, const Triangle& corners,
                                const FaceUvs& uvs) const {
  const FaceUvs& from = set.original[original];
  const glm::dvec2 u = from[1] - from[0], w = from[2] - from[0], s = uvs[1] - uvs[0], t = uvs[2] - uvs[0];
  const double area = cross(s, t);
  if (!(cross(u, w) * area > 0)) return false;
  const Vec3 p = corners[1] - corners[0], q = corners[2] - corners[0];
  const Vec3 b1 = (cross(u, t) * p + cross(s, u) * q) / area, b2 = (cross(w, t) * p + cross(s, w) * q) / area;
  const auto& [i, j, k] = sheets_.corners[original];
  const Vec3 a1 = surface_.point(j) - surface_.point(i), a2 = surface_.point(k) - surface_.point(i);
  const double a11 = glm::dot(a1, a1), a12 = glm::dot(a1, a2), a22 = glm::dot(a2, a2), b11 = glm::dot(b1, b1),
               b12 = glm::dot(b1, b2), b22 = glm::dot(b2, b2);
  const double det = glm::dot(glm::cross(a1, a2), glm::cross(a1, a2));
  const double trace = (a22 * b11 - 2 * a12 * b12 + a11 * b22) / det,
               product = glm::dot(glm::cross(b1, b2), glm::cross(b1, b2)) / det;
  constexpr double kMax = kMaxUvStretch * kMaxUvStretch, kMin = 1 / kMax;
  const auto polynomial = [&](double x) { return (x - trace) * x + product; };
  return trace >= 2 * kMin && trace <= 2 * kMax && polynomial(kMin) >= 0 && polynomial(kMax) >= 0;
}

bool UvStretch::allows(uint32_t v, uint32_t to, const Ring& ring) {
  return std::ranges::all_of(sets_, [&](const Set& set) { return allows(set, v, to, ring); });
}

bool UvStretch::allows(const Set& set, uint32_t v, uint32_t to, const Ring& ring) {
  const auto has = [&](const FlatSurface::Opposite& side) { return has_uvs(set.uvs[side.face]); };
  if (std::ranges::none_of(ring.sides, has)) return true;
  if (!std::ranges::all_of(ring.sides, has)) return false;
  const glm::dvec2 end = target(set, to, ring);
  collect_overlaps(set, ring);
  return std::ranges::all_of(ring.sides, [&](const FlatSurface::Opposite& side) {
    if (!is_changed(side, to)) return true;
    const FaceUvs after = changed(set, side.face, v, end);
    const double area = signed_area(after), before = signed_area(set.uvs[side.face]);
    if (before != 0 && !(area * before > 0)) return false;
    Triangle corners;
    for (size_t i = 0; i < 3; ++i) corners[i] = surface_.point(surface_.corners(side.face)[i]);
    corners[corner_of(side.face, v)] = surface_.point(to);
    return area == 0 || std::ranges::all_of(around_, [&](uint32_t original) {
             return !overlap(set.original[original], after) || is_within_bound(set, original, corners, after);
           });
  });
}

void UvStretch::collapse(uint32_t v, uint32_t to, const Ring& ring) {
  for (Set& set : sets_) {
    const glm::dvec2 end = target(set, to, ring);
    collect_overlaps(set, ring);
    for (const FlatSurface::Opposite& side : ring.sides) {
      std::vector<uint32_t>& own = set.overlaps[side.face];
      own.clear();
      if (!is_changed(side, to)) continue;
      set.uvs[side.face] = changed(set, side.face, v, end);
      if (!has_uvs(set.uvs[side.face]) || signed_area(set.uvs[side.face]) == 0) continue;
      std::ranges::copy_if(around_, std::back_inserter(own), [&](uint32_t original) {
        return overlap(set.original[original], set.uvs[side.face]);
      });
    }
  }
}

void CollapseRules::look_at(uint32_t v, Ring& ring) {
  KERF_ASSERT(surface_.in_use(v));
  ring.sides.clear();
  ring.vertices.clear();
  ++stamp_;
  surface_.for_each_face(v, [&](const FlatSurface::Opposite& side) {
    ring.sides.push_back(side);
    for (const uint32_t w : {side.from, side.to}) {
      if (std::exchange(mark_[w], stamp_) != stamp_) ring.vertices.push_back(w);
    }
  });
}

bool CollapseRules::allows(uint32_t v, uint32_t to, const Ring& ring) {
  KERF_ASSERT(!sheets_.locked[v]);
  return !turns_too_far(v, to, ring) && keeps_topology(v, to, ring) && !joins_sheets(to, ring);
}

bool CollapseRules::keeps_topology(uint32_t v, uint32_t to, const Ring& ring) {
  uint32_t between = 0;
  left_ = right_ = kNoIndex;
  for (const FlatSurface::Opposite& side : ring.sides) {
    if (side.from == to) left_ = side.to, ++between;
    if (side.to == to) right_ = side.from, ++between;
  }
  if (between != 2 || left_ == kNoIndex || right_ == kNoIndex || left_ == right_) return false;
  if (ring.sides.size() < 3) return false;
  if (is_hub(to)) return keeps_topology_of_hub(to, ring);
  // No other vertex is a neighbour of both ends, and no face has the same corners as a changed one.
  const auto is_third = [&](uint32_t w) { return mark_[w] == stamp_ && w != left_ && w != right_; };
  bool kept = true;
  surface_.for_each_face(to, [&](const FlatSurface::Opposite& side) {
    if (side.from == v || side.to == v) return;
    if (is_third(side.from) || is_third(side.to)) kept = false;
    if (mark_[side.from] == stamp_ && mark_[side.to] == stamp_) kept = false;
  });
  return kept;
}

// As for other vertices, but by the rings of those around the vertex.
bool CollapseRules::keeps_topology_of_hub(uint32_t to, const Ring& ring) const {
  const auto has_face = [&](uint32_t w, auto wanted) {
    bool found = false;
    surface_.for_each_face(w, [&](const FlatSurface::Opposite& side) { found = found || wanted(side); });
    return found;
  };
  const auto has = [](const FlatSurface::Opposite& side, uint32_t w) {
    return side.from == w || side.to == w;
  };
  for (const uint32_t w : ring.vertices) {
    if (w == to || w == left_ || w == right_) continue;
    if (is_hub(w) || has_face(w, [&](const auto& side) { return has(side, to); })) return false;
  }
  if (is_hub(left_) && is_hub(right_)) return false;
  const uint32_t a = is_hub(left_) ? right_ : left_, b = is_hub(left_) ? left_ : right_;
  return !has_face(a, [&](const auto& side) { return has(side, to) && has(side, b); });
}

// A new edge between two vertices shared by other sheets could coincide with an edge of those.
bool CollapseRules::joins_sheets(uint32_t to, const Ring& ring) const {
  return sheets_.shared[to] && std::any_of(ring.vertices.begin(), ring.vertices.end(), [&](uint32_t w) {
           return w != to && w != left_ && w != right_ && sheets_.shared[w];
         });
}

bool CollapseRules::turns_too_far(uint32_t v, uint32_t to, const Ring& ring) const {
  const Vec3 &before = surface_.point(v), &after = surface_.point(to);
  return std::any_of(ring.sides.begin(), ring.sides.end(), [&](const FlatSurface::Opposite& side) {
    if (side.from == to || side.to == to) return false;
    const Vec3 &a = surface_.point(side.from), &b = surface_.point(side.to);
    const Vec3 was = glm::cross(a - before, b - before), is = glm::cross(a - after, b - after);
    const double cosine = glm::dot(was, is);
    return !(cosine > 0 && cosine * cosine >= min_cosine2_ * glm::dot(was, was) * glm::dot(is, is));
  });
}

Collapser::Collapser(const Mesh& mesh, const FlatSheets& sheets, size_t faces,
                     std::span<const FaceId> followed, const Progress* progress)
    : sheets_(sheets),
      surface_(points_of(mesh, sheets), sheets.corners),
      rules_(sheets_, surface_),
      uv_stretch_(sheets_, surface_),
      quadrics_(surface_.vertices()),
      queued_(surface_.vertices(), kNever),
      followed_(mesh, sheets.frame, sheets.faces, followed),
      begin_(surface_.faces()),
      left_(begin_),
      target_(std::min(faces, begin_)),
      progress_(progress),
      reported_(begin_) {
  sum_quadrics();
}

void Collapser::sum_quadrics() {
  for (uint32_t f = 0; f < surface_.faces(); ++f) {
    const auto& [a, b, c] = surface_.corners(f);
    const Quadric q = Quadric::of(surface_.point(a), surface_.point(b), surface_.point(c));
    for (const uint32_t v : {a, b, c}) quadrics_[v] += q;
  }
}

double Collapser::area() const {
  double twice = 0;
  for (uint32_t f = 0; f < surface_.faces(); ++f) {
    if (!surface_.has(f)) continue;
    const auto& [a, b, c] = surface_.corners(f);
    twice +=
        glm::length(glm::cross(surface_.point(b) - surface_.point(a), surface_.point(c) - surface_.point(a)));
  }
  return 0.5 * twice;
}

void Collapser::bound_distance(std::optional<double> most) {
  most2_.reset();
  if (!most) return;
  if (!samples_) samples_.emplace(surface_);
  samples_->set_most(*most);
  most2_ = *most * *most;
}

bool Collapser::run_round(const Limits& limits) {
  rules_.set_min_cosine2(limits.min_cosine2);
  if (!report_progress()) return false;
  queue_all();
  while (left_ > limits.faces && !queue_.empty()) {
    const Queued next = queue_.top();
    queue_.pop();
    if (next.error != queued_[next.vertex]) continue;  // it has been queued again since
    queued_[next.vertex] = kNever;
    if (!may_go(next.vertex)) continue;  // it became a hub
    rules_.look_at(next.vertex, ring_);
    const Choice best = best_choice(next.vertex);
    if (best.to == kNoIndex) continue;
    if (best.error > next.error) {
      enqueue(next.vertex, best.error);
      continue;
    }
    collapse(next.vertex, best.to);
    if (reported_ - left_ > (begin_ - target_) / kReports && !report_progress()) return false;
  }
  return true;
}

bool Collapser::report_progress() {
  reported_ = left_;
  const double whole = static_cast<double>(std::max<size_t>(begin_ - target_, 1));
  return !progress_ || progress_->report(std::min(1.0, static_cast<double>(begin_ - left_) / whole));
}

void Collapser::queue_all() {
  std::vector<Queued> all;
  for (uint32_t v = 0; v < surface_.vertices(); ++v) {
    queued_[v] = kNever;
    if (!may_go(v)) continue;
    rules_.look_at(v, ring_);
    queued_[v] = least_error(v);
    all.push_back({queued_[v], v});
  }
  queue_ = decltype(queue_)(std::greater<>(), std::move(all));
}

void Collapser::enqueue(uint32_t v, double error) {
  if (queued_[v] == error) return;
  queued_[v] = error;
  queue_.push({error, v});
}

double Collapser::error_of(uint32_t v, uint32_t to) const {
  Quadric sum = quadrics_[v];
  sum += quadrics_[to];
  return sum.at(surface_.point(to));
}

// Returns the minimum error of all collapses, allowed or not. Precondition: ring_ is the vertex's.
double Collapser::least_error(uint32_t v) const {
  double least = kNever;
  for (const uint32_t w : ring_.vertices) least = std::min(least, error_of(v, w));
  return least;
}

// Returns the best allowed collapse of the vertex. Precondition: ring_ is the vertex's.
Collapser::Choice Collapser::best_choice(uint32_t v) {
  choices_.clear();
  for (const uint32_t w : ring_.vertices) choices_.push_back({error_of(v, w), w});
  std::sort(choices_.begin(), choices_.end(), [](const Choice& a, const Choice& b) {
    return a.error < b.error || (a.error == b.error && a.to < b.to);
  });
  for (const Choice& choice : choices_) {
    if (rules_.allows(v, choice.to, ring_) && stays_near(v, choice) &&
        uv_stretch_.allows(v, choice.to, ring_))
      return choice;
  }
  return {};
}

bool Collapser::stays_near(uint32_t v, const Choice& choice) {
  if (!most2_) return true;
  const double weight = quadrics_[v].weight + quadrics_[choice.to].weight;
  if (choice.error > kMaxOverBound2 * *most2_ * weight) return false;
  find_changed(choice.to);
  return samples_->are_near(around_, surface_.point(v), changed_);
}

// Finds the faces in ring_, and the remaining ones in their new shape.
void Collapser::find_changed(uint32_t to) {
  around_.clear();
  changed_.clear();
  for (const FlatSurface::Opposite& side : ring_.sides) {
    around_.push_back(side.face);
    if (side.from == to || side.to == to) continue;
    changed_.push_back({side.face, {surface_.point(to), surface_.point(side.from), surface_.point(side.to)}});
  }
}

void Collapser::hand_on(uint32_t v, uint32_t to) {
  const bool follows = std::any_of(ring_.sides.begin(), ring_.sides.end(),
                                   [&](const auto& side) { return followed_.lie_on(side.face); });
  if (!follows && !samples_) return;
  find_changed(to);
  if (follows) followed_.hand_on(around_, changed_);
  if (samples_) samples_->hand_on(around_, surface_.point(v), changed_);
}

void Collapser::collapse(uint32_t v, uint32_t to) {
  hand_on(v, to);
  uv_stretch_.collapse(v, to, ring_);
  surface_.collapse(v, to);
  quadrics_[to] += quadrics_[v];
  left_ -= 2;
  changed_vertices_ = ring_.vertices;
  for (const uint32_t w : changed_vertices_) {
    if (!may_go(w)) continue;
    rules_.look_at(w, ring_);
    enqueue(w, least_error(w));
  }
}

}  // namespace kerf
