#include "ui/render/passes/body_pass.h"

#include <array>
#include <cmath>

#include "core/base/angle.h"
#include "core/base/assert.h"
#include "ui/gl/state.h"
#include "ui/render/view/overlay_colours.h"
#include "ui/render/view/section_clip.h"

namespace kerf {

namespace {

using Line = ColouredLines::Line;
using State = BodyMarks::CentreMark::State;

constexpr float kHalfWidth = 0.9f;  // pixels
// In diagonals of the world.
constexpr double kNormal = 0.02, kContactArm = 0.002, kPointArm = 0.0025, kLeastCentre = 0.006,
                 kMostCentre = 0.02;
constexpr double kCentreOfRadius = 0.15;

constexpr double kHalfAxis = 0.025, kHubCircle = 0.012, kWeldArm = 0.006;
constexpr int kCircleSides = 16;

// Appends lines between points of the world.
class Lines {
 public:
  Lines(const FrameSpace& space, std::vector<Line>& lines) : space_(space), lines_(lines) {}

  void add(const Vec3& from, const Vec3& to, const glm::vec4& colour) {
    lines_.push_back({space_.from_world(from), space_.from_world(to), colour});
  }
  // Three lines that cross, along the axes of the world.
  void add_cross(const Vec3& at, double arm, const glm::vec4& colour) {
    for (int axis = 0; axis < 3; ++axis) {
      Vec3 way(0);
      way[axis] = arm;
      add(at - way, at + way, colour);
    }
  }

 private:
  const FrameSpace& space_;
  std::vector<Line>& lines_;
};

glm::vec4 colour_of_impulse(double share) {
  using namespace overlay_colours;
  const auto s = static_cast<float>(std::sqrt(share));
  return glm::mix(srgb(kLightContact, 1), srgb(kHeavyContact, 1), s);
}

uint32_t colour_of(State state) {
  using namespace overlay_colours;
  // In the order of State.
  constexpr std::array kColours{kAwake, kAsleep, kPinned};
  return kColours[static_cast<size_t>(state)];
}

void add_colliders(const Subject& subject, const BodyMarks& marks, double diagonal, Lines& lines) {
  const glm::vec4 point = srgb(overlay_colours::kColliderPoint, 1);
  const glm::vec4 chord = srgb(overlay_colours::kColliderChord, 0.9f);
  for (const BodyMarks::ColliderMarks& m : marks.colliders) {
    if (!subject.world.contains(m.body)) continue;
    const Placement& placement = subject.world.body(m.body).placement;
    for (const auto& [from, to] : m.chords)
      lines.add(placement.to_world(from), placement.to_world(to), chord);
    for (const Vec3& p : m.points) lines.add_cross(placement.to_world(p), kPointArm * diagonal, point);
  }
}

void add_circle(const Vec3& middle, const Vec3& axis, double radius, const glm::vec4& colour, Lines& lines) {
  const Vec3 other = std::abs(axis.x) < 0.5 ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
  const Vec3 u = glm::normalize(glm::cross(axis, other)), v = glm::cross(axis, u);
  const auto point = [&](int i) {
    const double angle = 2 * kPi * i / kCircleSides;
    return middle + radius * (std::cos(angle) * u + std::sin(angle) * v);
  };
  for (int i = 0; i < kCircleSides; ++i) lines.add(point(i), point(i + 1), colour);
}

void add_joint(const BodyMarks::JointMark& joint, double diagonal, Lines& lines) {
  using namespace overlay_colours;
  if (joint.kind == Joint::Kind::kWeld)
    return lines.add_cross(joint.anchor, kWeldArm * diagonal, srgb(kWeld, 1));
  const bool hub = joint.kind == Joint::Kind::kHub;
  const glm::vec4 colour = srgb(hub ? kHub : kHinge, 1);
  const Vec3 way = kHalfAxis * diagonal * joint.axis;
  lines.add(joint.anchor - way, joint.anchor + way, colour);
  if (hub) add_circle(joint.anchor, joint.axis, kHubCircle * diagonal, colour, lines);
}

}  // namespace

BodyPass::BodyPass(Shaders& shaders) : lines_(shaders) {}

void BodyPass::draw(const Subject& subject, double diagonal) {
  const BodyMarks* marks = subject.options.bodies.get();
  if (marks == nullptr) return;
  KERF_ASSERT(is_frame_bound());
  std::vector<Line> gathered;
  Lines lines(subject.space, gathered);
  add_colliders(subject, *marks, diagonal, lines);
  for (const BodyMarks::ContactMark& c : marks->contacts) {
    const glm::vec4 colour = colour_of_impulse(c.share);
    lines.add_cross(c.at, kContactArm * diagonal, colour);
    lines.add(c.at, c.at + kNormal * diagonal * c.normal, colour);
  }
  for (const BodyMarks::CentreMark& c : marks->centres) {
    const double arm =
        std::clamp(kCentreOfRadius * c.radius, kLeastCentre * diagonal, kMostCentre * diagonal);
    lines.add_cross(c.centre, arm, srgb(colour_of(c.state), 1));
  }
  for (const BodyMarks::JointMark& joint : marks->joints) add_joint(joint, diagonal, lines);
  const gl::ScopedState state({.depth = GL_NONE, .blend = gl::kOver});
  const SectionClip clip(subject.options);
  lines_.draw(gathered, kHalfWidth, ColouredLines::AtSection::kPart);
}

}  // namespace kerf
