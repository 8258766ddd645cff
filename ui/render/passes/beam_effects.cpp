#include "ui/render/passes/beam_effects.h"

#include <algorithm>
#include <cmath>

#include "core/base/assert.h"
#include "core/base/geometry.h"
#include "ui/gl/program.h"

namespace kerf {

namespace {

constexpr double kLightReach = 14;   // reach of the spot's light, in radii
constexpr double kMinReach = 0.012;  // of the world's unit
constexpr double kSpotRadii = 16;    // half the width of the spot, in radii of the beam
constexpr double kMinSpot = 34;      // pixels, if the frame is high enough
constexpr double kMaxSpot = 0.20;    // of the frame's height
constexpr double kCoreOfBeam = 0.9;  // width of the core over the radius of the beam
constexpr double kMinCore = 1.2;     // pixels, in frames up to 800 high
constexpr double kMaxCore = 3.2;     // pixels, in frames up to 800 high
constexpr double kHalo = 16;         // half the width of the ribbon over the maximum width of the core
constexpr double kFade = 1.0;        // m before an end in mid-air
constexpr double kMaxFade = 0.5;     // of the length of the beam

// Returns the size [pixels] of a length across the view at a distance of one metre.
double pixels_at_one_metre(const CameraView& view, double length, int height) {
  return length / view.tan_half_fov * 0.5 * height;
}

constexpr int kProbes = 8;  // rays on each circle around the beam that search for the edge of the burnt zone
constexpr double kProbeRadius = 1.05;  // radii

Vec3 any_perpendicular(const Vec3& d) {
  const Vec3 other = std::abs(d.y) < 0.9 ? Vec3(0, 1, 0) : Vec3(1, 0, 0);
  return glm::normalize(glm::cross(d, other));
}

constexpr double kSparksPerKilogram = 500, kPuffsPerKilogram = 27;
constexpr size_t kMaxSparks = 1200, kMaxPuffs = 160;
constexpr double kGravity = 9.81;       // m/s^2
constexpr double kStreak = 0.028;       // s, duration of flight shown by a streak
constexpr double kSparkWidth = 0.0035;  // m, half the width
constexpr double kBounce = 0.35;        // fraction of the speed kept in a bounce
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

double spot_half_width(double radius_pixels, int height) {
  return std::min(std::max(kSpotRadii * radius_pixels, kMinSpot), kMaxSpot * height);
}

BeamPicture ended_on_ground(BeamPicture beam, double ground, UpAxis up) {
  const double fall = height_of(beam.from - beam.to, up), above = height_of(beam.from, up) - ground;
  if (!(above > 0 && above <= fall)) return beam;
  beam.to = beam.from + (beam.to - beam.from) * (above / fall);
  beam.on_ground = true;
  return beam;
}

BeamPass::BeamPass(Shaders& shaders)
    : ribbon_(shaders.load({{"frame.glsl", "beam.vert"}, {"frame.glsl", "beam.frag"}})),
      spot_(shaders.load({{"frame.glsl", "spot.vert"}, {"spot.frag"}})) {}

void BeamPass::fill_in(FrameUniforms& frame, const FrameSpace& space, const BeamPicture& beam) {
  if (!beam.strike && !beam.on_ground) return;
  const double reach = std::max(kLightReach * beam.radius, kMinReach * space.unit);
  frame.spot = glm::vec4(space.from_world(beam.strike.value_or(beam.to)), space.length(reach));
  frame.beam = glm::vec4(space.from_world(beam.from), 0);
  const glm::vec4 colour = beam.strike ? glm::vec4(5.0f, 2.7f, 1.15f, 0) : glm::vec4(2.5f, 1.35f, 0.6f, 0);
  frame.spot_colour = static_cast<float>(beam.strength) * colour;
}

void BeamPass::draw(const CameraView& view, const BeamPicture& beam, const FrameSpace& space, double near,
                    int width, int height) const {
  gl::ScopedState state({.writes_depth = false, .blend = gl::kScreen});
  draw_ribbon(view, beam, near, width, height);
  state.set({.depth = GL_NONE, .blend = gl::kScreen});
  if (beam.strike) draw_spot(view, beam, space, height);
}

void BeamPass::draw_ribbon(const CameraView& view, const BeamPicture& beam, double near, int width,
                           int height) const {
  const double zoom = std::max(1.0, height / 800.0), most = kMaxCore * zoom;
  const auto seen = on_screen(view, beam.from, beam.to, width, height, kHalo * most);
  if (!seen) return;
  const double length = glm::length(beam.to - beam.from);
  const double strike = beam.strike ? glm::length(*beam.strike - beam.from) : length;
  const double fade = beam.on_ground ? 0 : std::min(kFade, kMaxFade * length);
  ribbon_.use();
  ribbon_.set("ends", glm::vec4(glm::vec2(seen->from), glm::vec2(seen->to)));
  const auto depth_of = [&](double share) {
    const Vec3 at = beam.from + (beam.to - beam.from) * share;
    return window_depth(view, near, glm::dot(at - view.eye, view.forward));
  };
  ribbon_.set("depths", glm::vec4(glm::vec2(seen->inverse_depth * view.focus), depth_of(seen->share.x),
                                  depth_of(seen->share.y)));
  ribbon_.set("share", glm::vec4(glm::vec2(seen->share * length / std::max(strike, 1e-300)),
                                 static_cast<float>(length / std::max(strike, 1e-300)),
                                 static_cast<float>(fade / std::max(strike, 1e-300))));
  ribbon_.set("strength", static_cast<float>(beam.strength));
  ribbon_.set("core", glm::vec4(pixels_at_one_metre(view, kCoreOfBeam * beam.radius, height) / view.focus,
                                kMinCore * zoom, most, kHalo));
  no_vertices_.draw(GL_TRIANGLE_STRIP, 8);
}

void BeamPass::draw_spot(const CameraView& view, const BeamPicture& beam, const FrameSpace& space,
                         int height) const {
  const double depth = glm::dot(*beam.strike - view.eye, view.forward);
  if (!(depth > 0)) return;
  const double pixels = pixels_at_one_metre(view, beam.radius, height) / (view.parallel ? view.focus : depth);
  spot_.use();
  spot_.set("centre", glm::vec4(space.from_world(*beam.strike), 1));
  spot_.set("strength", static_cast<float>(beam.strength));
  spot_.set("half_width", static_cast<float>(spot_half_width(pixels, height)));
  no_vertices_.draw(GL_TRIANGLE_STRIP, 4);
}

std::optional<double> first_hit(const World& world, const Pose& ray) {
  std::optional<double> nearest;
  std::vector<RayHit> hits;
  const World::Bounds bounds = world.bounds();
  const Vec3 far = glm::max(glm::abs(bounds.min - ray.origin), glm::abs(bounds.max - ray.origin));
  for (const BodyId id : cuttable(world)) {
    const Body& body = world.body(id);
    hits.clear();
    body.tree.crossings(body.mesh, body.placement.to_body(ray), {0, glm::length(far)}, hits);
    if (!hits.empty() && (!nearest || hits.front().length < *nearest)) nearest = hits.front().length;
  }
  return nearest;
}

std::optional<double> find_impact(const World& world, const Pose& beam, double radius, double overshoot,
                                  double reach) {
  std::optional<double> strike;
  const Vec3 u = any_perpendicular(beam.direction), w = glm::cross(beam.direction, u);
  for (const double aside : {0.0, kProbeRadius * radius, kProbeRadius * (radius + overshoot)}) {
    for (int i = 0; i < (aside > 0 ? kProbes : 1); ++i) {
      const double angle = 6.283185307179586 * i / kProbes;
      const Vec3 from = beam.origin + (u * std::cos(angle) + w * std::sin(angle)) * aside;
      const std::optional<double> hit = first_hit(world, {from, beam.direction});
      if (hit && *hit <= reach && (!strike || *hit < *strike)) strike = hit;
    }
  }
  return strike;
}

BeamPicture picture_of_beam(const World& world, const CutSettings& settings, const Pose& beam,
                            double length) {
  const double radius = settings.laser.radius, reach = settings.laser.range.high;
  const Vec3 end = beam.origin + beam.direction * std::min(reach, length);
  BeamPicture picture{beam.origin, end, std::nullopt, radius};
  const bool by_edge = settings.resolution.rule == Resolution::Rule::kTargetEdge;
  const double overshoot = by_edge ? settings.resolution.target_edge : 0.5 * radius;
  if (const auto strike = find_impact(world, beam, radius, overshoot, reach))
    picture.strike = beam.origin + beam.direction * *strike;
  return picture;
}

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

void Particles::add(const Removal& removal, const Vec3& up) {
  KERF_ASSERT(removal.mass >= 0 && removal.size > 0 && is_unit(up));
  const double mass = removal.mass / (removal.size * removal.size);
  for (add_owed(owed_sparks_, kSparksPerKilogram * mass, kMaxSparks); owed_sparks_ >= 1; --owed_sparks_)
    throw_spark(removal, up);
  for (add_owed(owed_puffs_, kPuffsPerKilogram * mass, kMaxPuffs); owed_puffs_ >= 1; --owed_puffs_)
    raise_puff(removal, up);
}

void Particles::throw_spark(const Removal& removal, const Vec3& up) {
  if (sparks_.size() >= kMaxSparks) return;
  const Vec3 towards = direction_in_ball() * 1.1 - removal.direction * 0.75 + up * 0.35;
  const double speed = removal.size * mixed(1.2, 4.2, random_.unit() * random_.unit());
  const double life = mixed(0.25, 0.9, random_.unit());
  sparks_.push_back({removal.at, towards * speed, removal.size, 0, life});
}

void Particles::raise_puff(const Removal& removal, const Vec3& up) {
  if (puffs_.size() >= kMaxPuffs) return;
  const Vec3 velocity = (up * 0.55 - removal.direction * 0.35 + direction_in_ball() * 0.22) * removal.size;
  puffs_.push_back({removal.at, velocity, removal.size, 0, mixed(0.7, 1.5, random_.unit())});
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

EffectsPass::EffectsPass(Shaders& shaders)
    : sparks_(shaders.load({{"frame.glsl", "particle.vert"}, {"frame.glsl", "spark.frag"}})),
      smoke_(shaders.load({{"frame.glsl", "particle.vert"}, {"frame.glsl", "smoke.frag"}})),
      scorches_(shaders.load({{"frame.glsl", "scorch.vert"}, {"scorch.frag"}})) {}

void EffectsPass::draw(const Effects& effects, const FrameSpace& space) {
  draw_scorches(effects.scorches, space);
  draw_smoke(effects.puffs, space);
  draw_sparks(effects.sparks, space);
}

// Alpha is the share of light that blooms, which smoke attenuates like the light itself.
void EffectsPass::draw_smoke(const std::vector<Puff>& puffs, const FrameSpace& space) {
  if (puffs.empty()) return;
  std::vector<std::pair<double, const Puff*>> far_first;
  for (const Puff& puff : puffs) far_first.emplace_back(-glm::length(puff.at - space.seen_from), &puff);
  std::stable_sort(far_first.begin(), far_first.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Corner> corners;
  for (const auto& [distance, puff] : far_first) {
    const glm::vec3 at = space.from_world(puff->at);
    add_quad(
        corners,
        {at, at, {}, {space.length(puff->radius), static_cast<float>(std::clamp(puff->opacity, 0.0, 1.0))}});
  }
  const gl::ScopedState state({.writes_depth = false, .blend = gl::kOver});
  smoke_.use();
  send(corners);
}

void EffectsPass::draw_sparks(const std::vector<Spark>& sparks, const FrameSpace& space) {
  if (sparks.empty()) return;
  std::vector<Corner> corners;
  for (const Spark& spark : sparks)
    add_quad(corners, {space.from_world(spark.at),
                       space.from_world(spark.tail),
                       {},
                       {space.length(spark.width), static_cast<float>(std::clamp(spark.heat, 0.0, 1.0))}});
  const gl::ScopedState state({.writes_depth = false, .blend = gl::kScreen});
  sparks_.use();
  send(corners);
}

// First darkens the surface under the scorches, then adds their glow.
void EffectsPass::draw_scorches(const std::vector<Scorch>& scorches, const FrameSpace& space) {
  if (scorches.empty()) return;
  std::vector<Corner> corners;
  for (const Scorch& s : scorches) {
    const Vec3 beside = std::abs(s.normal.y) < 0.9 ? Vec3(0, 1, 0) : Vec3(1, 0, 0);
    const Vec3 right = glm::normalize(glm::cross(beside, s.normal)) * s.radius;
    const Vec3 up = glm::cross(s.normal, right);
    const size_t first = corners.size();
    add_quad(corners, {{}, {}, {}, {0, static_cast<float>(std::clamp(s.heat, 0.0, 1.0))}});
    for (size_t i = first; i < corners.size(); ++i) {
      const Vec3 corner = s.at + right * double{corners[i].across.x} + up * double{corners[i].across.y};
      corners[i].at = corners[i].towards = space.from_world(corner);
    }
  }
  constexpr gl::Blend kDarken{GL_ZERO, GL_SRC_COLOR, GL_ZERO, GL_ONE};
  constexpr gl::DepthOffset kBefore{-2, -8};
  scorches_.use();
  gl::ScopedState state({.writes_depth = false, .blend = kDarken, .offset = kBefore});
  scorches_.set("glow", 0);
  send(corners);
  state.set({.writes_depth = false, .blend = gl::kScreen, .offset = kBefore});
  scorches_.set("glow", 1);
  send(corners);
}

void EffectsPass::add_quad(std::vector<Corner>& corners, Corner corner) {
  for (const glm::vec2 across : {glm::vec2(-1, -1), {1, -1}, {1, 1}, {-1, -1}, {1, 1}, {-1, 1}}) {
    corner.across = across;
    corners.push_back(corner);
  }
}

void EffectsPass::send(const std::vector<Corner>& corners) {
  corners_.send(corners);
  glDrawArrays(GL_TRIANGLES, 0, corners_.count());
}

}  // namespace kerf
