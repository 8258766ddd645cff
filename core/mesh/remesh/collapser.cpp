#include "core/mesh/remesh/collapser.h"

#include <algorithm>
#include <cmath>

namespace kerf {

namespace {

std::vector<Vec3> points_of(const Mesh& mesh, const FlatSheets& sheets) {
  std::vector<Vec3> points(sheets.vertices.size());
  for (uint32_t v = 0; v < points.size(); ++v) points[v] = sheets.point(mesh, v);
  return points;
}

// Where the mean square of the distance from the planes is so many times the bound, the samples are not
// asked: few would be near, and looking for that takes half of the time.
constexpr double kMostOverBound2 = 4;

// Reports in a whole simplification, beside one a round.
constexpr size_t kReports = 64;

}  // namespace

Collapser::Collapser(const Mesh& mesh, const FlatSheets& sheets, size_t faces,
                     std::span<const FaceId> followed, const Progress* progress)
    : sheets_(sheets),
      surface_(points_of(mesh, sheets), sheets.corners),
      rules_(sheets_, surface_),
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
  rules_.set_least_cosine2(limits.least_cosine2);
  if (!go_on()) return false;
  queue_all();
  while (left_ > limits.faces && !queue_.empty()) {
    const Queued next = queue_.top();
    queue_.pop();
    if (next.error != queued_[next.vertex]) continue;  // it was queued again since
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
    if (reported_ - left_ > (begin_ - target_) / kReports && !go_on()) return false;
  }
  return true;
}

bool Collapser::go_on() {
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

// The least error of all collapses of the vertex, allowed or not. Precondition: ring_ is its.
double Collapser::least_error(uint32_t v) const {
  double least = kNever;
  for (const uint32_t w : ring_.vertices) least = std::min(least, error_of(v, w));
  return least;
}

// The best collapse of the vertex among those that are allowed. Precondition: ring_ is its.
Collapser::Choice Collapser::best_choice(uint32_t v) {
  choices_.clear();
  for (const uint32_t w : ring_.vertices) choices_.push_back({error_of(v, w), w});
  std::sort(choices_.begin(), choices_.end(), [](const Choice& a, const Choice& b) {
    return a.error < b.error || (a.error == b.error && a.to < b.to);
  });
  for (const Choice& choice : choices_) {
    if (rules_.allows(v, choice.to, ring_) && stays_near(v, choice)) return choice;
  }
  return {};
}

bool Collapser::stays_near(uint32_t v, const Choice& choice) {
  if (!most2_) return true;
  const double weight = quadrics_[v].weight + quadrics_[choice.to].weight;
  if (choice.error > kMostOverBound2 * *most2_ * weight) return false;
  find_changed(choice.to);
  return samples_->are_near(around_, surface_.point(v), changed_);
}

// Finds the faces in ring_, and those of them that stay as they will be.
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
