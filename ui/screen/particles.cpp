#include "ui/screen/particles.h"

#include <algorithm>

#include "core/base/assert.h"
#include "core/base/unit_vector.h"

namespace kerf {

namespace {

constexpr double kSparksPerKilogram = 500, kPuffsPerKilogram = 27;
constexpr size_t kMostSparks = 1200, kMostPuffs = 160;
constexpr double kGravity = 9.81;       // m/s^2
constexpr double kStreak = 0.028;       // s of flight that a streak shows
constexpr double kSparkWidth = 0.0035;  // m, half of it
constexpr double kBounce = 0.35;        // of the speed that a bounce leaves
constexpr double kDrag = 1.1;           // of smoke, 1/s

double mixed(double a, double b, double share) { return a + (b - a) * share; }

void add_owed(double& owed, double more, size_t most) {
  owed = std::min(owed + more, static_cast<double>(most));
}

template <typename Particle>
void drop_old(std::vector<Particle>& particles) {
  std::erase_if(particles, [](const Particle& p) { return p.age >= p.life; });
}

}  // namespace

void Particles::clear() {
  sparks_.clear();
  puffs_.clear();
}

Vec3 Particles::direction_in_ball() {
  for (;;) {
    const double x = random_.uniform(-1, 1), y = random_.uniform(-1, 1), z = random_.uniform(-1, 1);
    if (x * x + y * y + z * z <= 1) return {x, y, z};
  }
}

void Particles::add(const Bite& bite, const Vec3& up) {
  KERF_ASSERT(bite.mass >= 0 && bite.size > 0 && is_unit(up));
  const double mass = bite.mass / (bite.size * bite.size);
  for (add_owed(owed_sparks_, kSparksPerKilogram * mass, kMostSparks); owed_sparks_ >= 1; --owed_sparks_)
    throw_spark(bite, up);
  for (add_owed(owed_puffs_, kPuffsPerKilogram * mass, kMostPuffs); owed_puffs_ >= 1; --owed_puffs_)
    raise_puff(bite, up);
}

void Particles::throw_spark(const Bite& bite, const Vec3& up) {
  if (sparks_.size() >= kMostSparks) return;
  const Vec3 towards = direction_in_ball() * 1.1 - bite.direction * 0.75 + up * 0.35;
  const double speed = bite.size * mixed(1.2, 4.2, random_.unit() * random_.unit());
  const double life = mixed(0.25, 0.9, random_.unit());
  sparks_.push_back({bite.at, towards * speed, bite.size, 0, life});
}

void Particles::raise_puff(const Bite& bite, const Vec3& up) {
  if (puffs_.size() >= kMostPuffs) return;
  const Vec3 velocity = (up * 0.55 - bite.direction * 0.35 + direction_in_ball() * 0.22) * bite.size;
  puffs_.push_back({bite.at, velocity, bite.size, 0, mixed(0.7, 1.5, random_.unit())});
}

void Particles::advance(double seconds, const Vec3& up, double ground) {
  KERF_ASSERT(seconds >= 0 && is_unit(up));
  for (MovingSpark& s : sparks_) {
    s.velocity -= up * (kGravity * s.size * seconds);
    s.at += s.velocity * seconds;
    s.age += seconds;
    const double below = ground - glm::dot(s.at, up), sinking = -glm::dot(s.velocity, up);
    if (below > 0 && sinking > 0) {
      s.at += up * below;
      s.velocity = (s.velocity + up * (sinking * (1 + kBounce))) * mixed(0.5, 0.8, random_.unit());
    }
  }
  for (RisingPuff& p : puffs_) {
    p.velocity /= 1 + kDrag * seconds;
    p.at += (p.velocity + up * (0.25 * p.size)) * seconds;
    p.age += seconds;
  }
  drop_old(sparks_);
  drop_old(puffs_);
}

void Particles::append_to(Effects& effects) const {
  for (const MovingSpark& s : sparks_) {
    const double left = 1 - s.age / s.life;
    effects.sparks.push_back(
        {s.at, s.at - s.velocity * std::min(kStreak, s.age), kSparkWidth * s.size, left});
  }
  for (const RisingPuff& p : puffs_) {
    const double share = p.age / p.life, fade_in = std::min(1.0, p.age / 0.15);
    effects.puffs.push_back({p.at, p.size * mixed(0.05, 0.42, share), 0.17 * fade_in * (1 - share)});
  }
}

}  // namespace kerf
