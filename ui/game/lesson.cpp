#include "ui/game/lesson.h"

#include <algorithm>
#include <limits>

namespace kerf {

namespace {

constexpr double kAhead = 14, kReached = 3;  // m, to the place to drive to
constexpr size_t kEnough = 60;               // faces, of a drum that does not fall in two

// Where a body is: the middle of what is left of it.
Vec3 place_of(const Match& match, BodyId id) { return middle_of(match.world().body(id)); }

// The nearest thing that can be cut and is no larger than a drum.
BodyId nearest_drum(const Match& match, const Vec3& from) {
  constexpr double kLargest = 1.5;  // m, of the diagonal
  BodyId nearest;
  double least = std::numeric_limits<double>::infinity();
  for (const BodyId id : match.world().ids()) {
    const Body& body = match.world().body(id);
    const bool serves = !match.is_wall(id) && match.vehicle_of(id) == Event::kNobody &&
                        body.tree.leaf_count() > 0 &&
                        glm::length(body.bounds().max - body.bounds().min) < kLargest;
    const double distance = glm::distance(middle_of(body), from);
    if (!serves || distance >= least) continue;
    least = distance;
    nearest = id;
  }
  return nearest;
}

}  // namespace

Lesson::Lesson(const Match& match) {
  const Placement& own = match.world().body(match.vehicles()[Match::kPlayer].chassis).placement;
  place_ = own.to_world({0, 0, kAhead});
  drum_ = nearest_drum(match, place_);
}

std::optional<Lesson::Task> Lesson::task(const Match& match) const {
  switch (step_) {
    case Step::kDrive:
      return Task{"Drive here: W A S D or the arrows", place_};
    case Step::kDrum:
      return Task{"Cut this drum in two: the mouse aims, hold the left button", place_of(match, drum_)};
    case Step::kWheel:
      return Task{"Cut a wheel off this car: drive within 18 m, draw the beam across",
                  place_of(match, match.vehicles().back().chassis)};
    case Step::kDone:
      break;
  }
  return std::nullopt;
}

bool Lesson::is_done(const Match& match) {
  const Vehicle& own = match.vehicles()[Match::kPlayer];
  switch (step_) {
    case Step::kDrive:
      return glm::distance(match.world().body(own.chassis).placement.position, place_) < kReached;
    case Step::kDrum:
      for (const Event& e : match.events()) {
        if (e.kind == Event::Kind::kCut && e.body == drum_) drum_faces_ += static_cast<size_t>(e.size);
      }
      return !drum_.valid() || !match.world().contains(drum_) || drum_faces_ > kEnough ||
             std::ranges::any_of(match.delta().detached, [&](const Detached& d) { return d.from == drum_; });
    case Step::kWheel:
      return std::ranges::any_of(match.events(), [](const Event& e) {
        return e.vehicle != Match::kPlayer &&
               (e.kind == Event::Kind::kWheelLost || e.kind == Event::Kind::kKilled);
      });
    case Step::kDone:
      break;
  }
  return false;
}

bool Lesson::hear(const Match& match) {
  if (!is_done(match)) return false;
  step_ = static_cast<Step>(static_cast<int>(step_) + 1);
  if (step_ == Step::kDrum && !drum_.valid()) step_ = Step::kWheel;
  return true;
}

}  // namespace kerf
