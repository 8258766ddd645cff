#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

#include "core/base/assert.h"
#include "core/base/deterministic_math.h"
#include "core/base/principal_axes.h"
#include "core/mesh/face_batches.h"
#include "core/tree/surface_comparison.h"

namespace kerf {

namespace {

constexpr size_t kSamples = 5000, kTrialSamples = 500;
constexpr int kIterations = 100, kTrialIterations = 20;
constexpr double kFirstDamping = 1e-3;  // relative to the mean diagonal of the normal equations
constexpr int kRejections = 12;         // in a row, each with ten times the damping, before it ends
constexpr double kMinDecrease = 1e-9;   // of the sum of squares in an iteration, relative to it

// The centroid and the principal axes of samples, by descending extent and right-handed.
struct SampleFrame {
  explicit SampleFrame(std::span<const Vec3> samples) : centre(mean_of(samples)) {
    const std::array<Vec3, 3> directions = principal_axes(samples, centre);
    axes = {directions[0], directions[1], glm::cross(directions[0], directions[1])};
  }
  Vec3 centre;
  glm::dmat3 axes;  // columns
};

// Rotates about a point to another one.
RigidMotion rotate_to(const glm::dquat& rotation, const Vec3& from, const Vec3& to) {
  return {rotation, to - rotation * from};
}

// Returns the centroid of the area of a surface; of samples if it has no area.
Vec3 centroid_of(const Mesh& mesh) {
  double area = 0;
  Vec3 centroid(0);
  for_each_triangle(mesh, 0, mesh.face_slots(), [&](FaceId, const Triangle& t) { area += triangle_area(t); });
  if (!(area > 0)) return mean_of(sample_surface(mesh, kTrialSamples));
  for_each_triangle(mesh, 0, mesh.face_slots(), [&](FaceId, const Triangle& t) {
    centroid += triangle_area(t) / area * ((t[0] + t[1] + t[2]) / 3.0);
  });
  return centroid;
}

// Equal centroids, and equal principal axes in the four orientations that keep them right-handed.
std::vector<RigidMotion> trial_motions(std::span<const Vec3> a, std::span<const Vec3> b) {
  const SampleFrame from(a), to(b);
  std::vector<RigidMotion> motions{{}, rotate_to({1, 0, 0, 0}, from.centre, to.centre)};
  for (const auto& [x, y] : {std::array{1, 1}, {1, -1}, {-1, 1}, {-1, -1}}) {
    glm::dmat3 axes = to.axes;
    axes[0] *= x;
    axes[1] *= y;
    axes[2] *= x * y;
    const glm::dquat rotation = glm::normalize(glm::quat_cast(axes * glm::transpose(from.axes)));
    motions.push_back(rotate_to(rotation, from.centre, to.centre));
  }
  return motions;
}

// The normal equations of a Gauss-Newton step for six unknowns: three of a rotation, scaled to a length, and
// three of a translation.
struct NormalEquations {
  std::array<std::array<double, 6>, 6> matrix{};
  std::array<double, 6> right{};

  void add(const std::array<double, 6>& row, double residual) {
    for (size_t i = 0; i < 6; ++i) {
      for (size_t k = 0; k <= i; ++k) matrix[i][k] += row[i] * row[k];
      right[i] -= row[i] * residual;
    }
  }

  // Solves the damped system by Cholesky's method. Precondition: damping > 0.
  std::array<double, 6> solve(double damping) const {
    KERF_ASSERT(damping > 0);
    auto m = matrix;
    double trace = 0;
    for (size_t i = 0; i < 6; ++i) trace += matrix[i][i];
    std::array<double, 6> x = right;
    if (!(trace > 0)) return {};
    for (size_t i = 0; i < 6; ++i) {
      m[i][i] += damping * trace / 6;
      for (size_t k = 0; k <= i; ++k) {
        for (size_t j = 0; j < k; ++j) m[i][k] -= m[i][j] * m[k][j];
        m[i][k] =
            i == k ? std::sqrt(std::max(m[i][i], std::numeric_limits<double>::min())) : m[i][k] / m[k][k];
      }
      for (size_t j = 0; j < i; ++j) x[i] -= m[i][j] * x[j];
      x[i] /= m[i][i];
    }
    for (size_t i = 6; i-- > 0;) {
      for (size_t j = i + 1; j < 6; ++j) x[i] -= m[j][i] * x[j];
      x[i] /= m[i][i];
    }
    return x;
  }
};

// Minimises the sum of the squared distances of samples from a surface.
class Registration {
 public:
  Registration(std::span<const Vec3> samples, const Surface& surface)
      : samples_(samples), surface_(surface), centre_(mean_of(samples)) {
    KERF_ASSERT(!samples.empty());
    for (const Vec3& p : samples) size_ = std::max(size_, glm::length(p - centre_));
    if (size_ == 0) size_ = 1;
  }

  // Starts from a motion. Fails with cancelled() when stopped.
  Status run(const RigidMotion& start, int iterations, const Progress& progress) {
    adopt({start, nearest_points(start)});
    double damping = kFirstDamping;
    for (int i = 0, rejected = 0; i < iterations && rejected < kRejections && best_.cost > 0; ++i) {
      if (!progress.report(static_cast<double>(i) / iterations)) return cancelled();
      const RigidMotion next = moved(equations_.solve(damping));
      State state{next, nearest_points(next)};
      const double cost = cost_of(state);
      if (!(cost < best_.cost)) {
        damping *= 10;
        ++rejected;
        continue;
      }
      const bool slow = cost > best_.cost * (1 - kMinDecrease);
      adopt(std::move(state));
      if (slow) break;
      damping /= 10;
      rejected = 0;
    }
    return Done{};
  }

  const RigidMotion& motion() const { return best_.motion; }
  double cost() const { return best_.cost; }

 private:
  struct State {
    RigidMotion motion;
    std::vector<PointOnFace> nearest;  // by sample
    double cost = 0;
  };

  std::vector<PointOnFace> nearest_points(const RigidMotion& motion) const {
    constexpr size_t kPointsARange = 256;
    std::vector<PointOnFace> nearest(samples_.size());
    for_each_range(samples_.size(), kPointsARange, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i)
        nearest[i] = *surface_.tree.nearest_point(surface_.mesh, motion.apply(samples_[i]));
    });
    return nearest;
  }

  // The mean of the squared distances, relative to the size.
  double cost_of(const State& state) const {
    KERF_ASSERT(state.nearest.size() == samples_.size());
    double sum = 0;
    for (const PointOnFace& p : state.nearest) sum += p.distance2 / (size_ * size_);
    return sum / static_cast<double>(state.nearest.size());
  }

  void adopt(State state) {
    best_ = std::move(state);
    best_.cost = cost_of(best_);
    equations_ = {};
    const Vec3 centre = best_.motion.apply(centre_);
    for (size_t i = 0; i < samples_.size(); ++i) {
      const Vec3 at = best_.motion.apply(samples_[i]), apart = at - best_.nearest[i].point;
      const double distance = glm::length(apart);
      const Vec3 direction = distance > 0 ? apart / distance : normal_at(best_.nearest[i].face);
      const Vec3 lever = glm::cross((at - centre) / size_, direction);
      equations_.add({lever.x, lever.y, lever.z, direction.x, direction.y, direction.z}, distance / size_);
    }
  }

  Vec3 normal_at(FaceId f) const {
    const Triangle t = surface_.mesh.triangle(f);
    const Vec3 normal = glm::cross(t[1] - t[0], t[2] - t[0]);
    const double length = glm::length(normal);
    return length > 0 ? normal / length : Vec3(0);
  }

  // The best motion followed by a step, whose rotation is about the centre of the samples.
  RigidMotion moved(const std::array<double, 6>& step) const {
    const Vec3 turn(step[0], step[1], step[2]);
    const double angle = glm::length(turn);
    const glm::dquat rotation =
        angle > 0 ? axis_angle(turn / angle, std::min(angle, kPi)) : glm::dquat(1, 0, 0, 0);
    const Vec3 centre = best_.motion.apply(centre_);
    return rotate_to(glm::normalize(rotation * best_.motion.rotation), centre_,
                     centre + size_ * Vec3(step[3], step[4], step[5]));
  }

  std::span<const Vec3> samples_;
  const Surface& surface_;
  Vec3 centre_;
  double size_ = 0;
  State best_;
  NormalEquations equations_;
};

Result<RigidMotion> register_surface(const Surface& a, const Surface& b, const Progress* progress) {
  const std::vector<Vec3> samples = sample_surface(a.mesh, kSamples);
  const std::vector<Vec3> few = sample_surface(a.mesh, kTrialSamples);
  ProgressShares shares(progress);
  Registration trial(few, b);
  std::optional<RigidMotion> best;
  double least = 0;
  const std::vector<RigidMotion> motions = trial_motions(samples, sample_surface(b.mesh, kSamples));
  for (const RigidMotion& start : motions) {
    const Progress own = shares.next(0.5 / static_cast<double>(motions.size()));
    if (const Status s = trial.run(start, kTrialIterations, own); !s) return s.error();
    if (best && trial.cost() >= least) continue;
    best = trial.motion();
    least = trial.cost();
  }
  const Progress own = shares.next(0.5);
  Registration final(samples, b);
  if (const Status s = final.run(*best, kIterations, own); !s) return s.error();
  return final.motion();
}

}  // namespace

Result<RigidMotion> align_surfaces(const Surface& a, const Surface& b, Alignment alignment,
                                   const Progress* progress) {
  KERF_ASSERT(a.mesh.live_faces() > 0 && b.mesh.live_faces() > 0);
  switch (alignment) {
    case Alignment::kNone:
      return RigidMotion{};
    case Alignment::kCentre:
      return rotate_to({1, 0, 0, 0}, centroid_of(a.mesh), centroid_of(b.mesh));
    case Alignment::kIcp:
      break;
  }
  return register_surface(a, b, progress);
}

}  // namespace kerf
