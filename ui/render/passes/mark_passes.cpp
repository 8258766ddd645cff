#include "ui/render/passes/mark_passes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "core/base/assert.h"
#include "core/base/deterministic_math.h"
#include "ui/gl/program.h"
#include "ui/render/view/camera.h"
#include "ui/render/view/colours.h"

namespace kerf {

namespace {

constexpr float kDarkAround = 0.8f;  // pixels

using Line = ColouredLines::Line;
using State = BodyMarks::CentreMark::State;

constexpr float kHalfWidth = 0.9f;  // pixels
// In diagonals of the world.
constexpr double kNormal = 0.02, kContactArm = 0.002, kPointArm = 0.0025, kMinCentre = 0.006,
                 kMaxCentre = 0.02;
constexpr double kCentreOfRadius = 0.15;

constexpr double kHalfAxis = 0.025, kHubCircle = 0.012, kWeldArm = 0.006;
constexpr int kCircleSides = 16;

class Lines {
 public:
  Lines(const FrameSpace& space, std::vector<Line>& lines) : space_(space), lines_(lines) {}

  void add(const Vec3& from, const Vec3& to, const glm::vec4& colour) {
    lines_.push_back({space_.from_world(from), space_.from_world(to), colour});
  }
  // Three crossing lines along the axes of the world.
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

using Kind = StageMarks::Kind;

constexpr float kEdgeHalfWidth = 0.7f, kLastHalfWidth = 1.6f;  // pixels

// The colour of a kind of marks, and the opacity of its fills and lines.
struct StageLook {
  uint32_t colour;
  float fill = 0.42f, line = 0.9f;
};

// In the order of StageMarks::Kind.
constexpr std::array kStageLooks{StageLook{overlay_colours::kSwept, 0.07f},
                                 StageLook{overlay_colours::kHit},
                                 StageLook{overlay_colours::kAdded},
                                 StageLook{overlay_colours::kRemoved, 0.34f, 0.7f},
                                 StageLook{.colour = overlay_colours::kEntered, .line = 0.6f},
                                 StageLook{.colour = overlay_colours::kCulled, .line = 0.45f},
                                 StageLook{overlay_colours::kMissed},
                                 StageLook{overlay_colours::kTouched},
                                 StageLook{overlay_colours::kLast}};
static_assert(kStageLooks.size() == static_cast<size_t>(Kind::kLast) + 1);

const StageLook& stage_look(Kind kind) { return kStageLooks[static_cast<size_t>(kind)]; }

// Converts positions in the frame of a body to drawn positions.
class DrawnAt {
 public:
  DrawnAt(const Subject& subject, BodyId id)
      : space_(subject.space),
        placement_(subject.world.body(id).placement),
        looks_(id, subject.world.body(id), subject.options) {}

  bool hidden(uint32_t piece) const { return looks_.of(piece).hidden; }
  glm::vec3 operator()(const Vec3& place, uint32_t piece) const {
    const PieceLook& look = looks_.of(piece);
    return space_.from_world(look.turn * placement_.to_world(place) + look.offset);
  }

 private:
  const FrameSpace& space_;
  const Placement& placement_;
  BodyLooks looks_;
};

constexpr float kLinkHalfWidth = 0.7f;                        // pixels
constexpr float kLoopHalfWidth = 1.1f, kEarlierLoop = 0.45f;  // pixels; opacity
constexpr float kMinRadius = 1.6f, kMaxRadius = 7;            // of a disc, pixels
constexpr float kRadiusOfLink = 0.22f;                        // of the usual length of a link

// The drawn positions of nodes: moved with their bodies, displaced and turned with their pieces; none for
// hidden pieces.
class Places {
 public:
  Places(const Subject& subject, const DrawnGraph& graph) : subject_(subject), graph_(graph) {}

  std::optional<glm::vec3> of(const DrawnGraph::Node& node) {
    const Vec3 middle = graph_.moved_with(node.face.body, node.middle, subject_.world);
    if (node.removed || !is_live(node.face)) return subject_.space.from_world(middle);
    const BodyId id = node.face.body;
    const auto found = looks_.try_emplace(id, id, subject_.world.body(id), subject_.options).first;
    const PieceLook& look = found->second.of(subject_.world.body(id).mesh, node.face.face);
    if (look.hidden) return std::nullopt;
    return subject_.space.from_world(look.turn * middle + look.offset);
  }

 private:
  bool is_live(const GraphNode& n) const {
    return subject_.world.contains(n.body) && subject_.world.body(n.body).mesh.is_live(n.face);
  }

  const Subject& subject_;
  const DrawnGraph& graph_;
  std::map<BodyId, BodyLooks> looks_;
};

// Returns the median length of the links in the frame, in pixels of a frame of usual height.
float usual_length(const std::vector<std::pair<glm::vec3, glm::vec3>>& links, const FrameUniforms& frame) {
  const glm::vec2 half = 0.5f * glm::vec2(frame.viewport.x, frame.viewport.y);
  std::vector<float> lengths;
  for (const auto& [from, to] : links) {
    const glm::vec4 a = frame.clip_from_frame * glm::vec4(from, 1),
                    b = frame.clip_from_frame * glm::vec4(to, 1);
    if (a.w > 0 && b.w > 0) lengths.push_back(glm::length((glm::vec2(a) / a.w - glm::vec2(b) / b.w) * half));
  }
  if (lengths.empty()) return 0;
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  return *middle / std::max(1.0f, frame.viewport.y / kUsualHeight);
}

}  // namespace

ColouredLines::ColouredLines(Shaders& shaders)
    : program_(shaders.load({{"frame.glsl", "line.glsl", "link.vert"}, {"box.frag"}})) {}

// First the dark outlines, slightly wider.
void ColouredLines::draw(std::span<const Line> lines, float half_width, AtSection section) {
  if (lines.empty()) return;
  KERF_ASSERT(glIsEnabled(GL_BLEND));
  lines_.send(lines);
  program_.use();
  program_.set("in_part", section == AtSection::kPart ? 1 : 0);
  for (const bool dark : {true, false}) {
    program_.set("half_width", half_width + (dark ? kDarkAround : 0));
    program_.set("shade", dark ? glm::vec4(0.02f, 0.025f, 0.03f, 1) : glm::vec4(0));
    glDrawArraysInstanced(GL_TRIANGLES, 0, kVerticesOfLine, lines_.count());
  }
}

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
    const double arm = std::clamp(kCentreOfRadius * c.radius, kMinCentre * diagonal, kMaxCentre * diagonal);
    lines.add_cross(c.centre, arm, srgb(colour_of(c.state), 1));
  }
  for (const BodyMarks::JointMark& joint : marks->joints) add_joint(joint, diagonal, lines);
  const gl::ScopedState state({.depth = GL_NONE, .blend = gl::kOver});
  const SectionClip clip(subject.options);
  lines_.draw(gathered, kHalfWidth, ColouredLines::AtSection::kPart);
}

StagePass::StagePass(Shaders& shaders)
    : fills_(shaders.load({{"frame.glsl", "line.glsl", "fill.vert"}, {"fill.frag"}})), lines_(shaders) {}

uint32_t colour_of(StageMarks::Kind kind) { return stage_look(kind).colour; }

void StagePass::draw(const Subject& subject) {
  if (!subject.options.stage) return;
  std::vector<Corner> corners;
  std::vector<ColouredLines::Line> lines, last;
  for (const StageMarks::OfBody& marks : subject.options.stage->bodies) {
    if (!subject.world.contains(marks.body)) continue;
    const DrawnAt at(subject, marks.body);
    for (const StageMarks::Fill& f : marks.fills) {
      if (at.hidden(f.piece)) continue;
      const glm::vec4 colour = srgb(colour_of(f.kind), stage_look(f.kind).fill);
      for (const Vec3& corner : f.corners) corners.push_back({at(corner, f.piece), colour});
    }
    for (const StageMarks::Line& l : marks.lines) {
      if (at.hidden(l.piece)) continue;
      (l.kind == Kind::kLast ? last : lines)
          .push_back(
              {at(l.from, l.piece), at(l.to, l.piece), srgb(colour_of(l.kind), stage_look(l.kind).line)});
    }
  }
  gl::ScopedState state({.writes_depth = false, .blend = gl::kOver});
  const SectionClip clip(subject.options);
  draw_fills(corners);
  lines_.draw(lines, kEdgeHalfWidth, ColouredLines::AtSection::kPart);
  state.set({.depth = GL_NONE, .blend = gl::kOver});
  lines_.draw(last, kLastHalfWidth, ColouredLines::AtSection::kPart);
}

void StagePass::draw_fills(const std::vector<Corner>& corners) {
  if (corners.empty()) return;
  corners_.send(corners);
  fills_.use();
  glDrawArrays(GL_TRIANGLES, 0, corners_.count());
}

uint32_t colour_of(DrawnGraph::State state) {
  // In the order of DrawnGraph::State.
  constexpr std::array kColours{overlay_colours::kRemoved, overlay_colours::kReached,
                                overlay_colours::kUnmarked, overlay_colours::kApart};
  return kColours[static_cast<size_t>(state)];
}

GraphPass::GraphPass(Shaders& shaders)
    : links_(shaders), nodes_(shaders.load({{"frame.glsl", "line.glsl", "node.vert"}, {"node.frag"}})) {}

void GraphPass::draw(const Subject& subject, const FrameUniforms& frame) {
  const ViewOptions& options = subject.options;
  gl::ScopedState state({.writes_depth = false, .blend = gl::kOver});
  if (options.show.graph && options.graph) draw_graph(subject, *options.graph, frame);
  state.set({.depth = GL_NONE, .blend = gl::kOver});
  if (options.lit_face) draw_lit_face(subject);
}

void GraphPass::draw_graph(const Subject& subject, const DrawnGraph& graph, const FrameUniforms& frame) {
  Places places(subject, graph);
  std::vector<std::optional<glm::vec3>> at;
  for (const DrawnGraph::Node& n : graph.nodes) at.push_back(places.of(n));
  std::vector<std::pair<glm::vec3, glm::vec3>> ends;
  std::vector<ColouredLines::Line> links;
  for (const auto& [a, b] : graph.edges) {
    if (!at[a] || !at[b]) continue;
    const bool cut = graph.is_cut({a, b});
    const glm::vec4 colour =
        srgb(cut ? overlay_colours::kRemoved : colour_of(graph.state(graph.nodes[a])), 0.8f);
    ends.emplace_back(*at[a], *at[b]);
    links.push_back({*at[a], *at[b], colour});
  }
  const float radius = std::clamp(kRadiusOfLink * usual_length(ends, frame), kMinRadius, kMaxRadius);
  std::vector<Disc> discs;
  for (size_t i = 0; i < at.size(); ++i) {
    const DrawnGraph::Node& n = graph.nodes[i];
    const float larger = n.faces > 1 ? 1.25f : 1;
    if (at[i]) discs.push_back({*at[i], radius * larger, srgb(colour_of(graph.state(n)), 1)});
  }
  const SectionClip clip(subject.options);
  links_.draw(links, kLinkHalfWidth);
  draw_discs(discs);
  draw_loops(subject, graph);
}

// Draws the last loop closed so far over the others.
void GraphPass::draw_loops(const Subject& subject, const DrawnGraph& graph) {
  KERF_ASSERT(std::is_sorted(graph.loops.begin(), graph.loops.end(),
                             [](const auto& a, const auto& b) { return a.removal < b.removal; }));
  size_t closed = 0;
  while (closed < graph.loops.size() && graph.loops[closed].removal <= graph.removals) ++closed;
  std::vector<ColouredLines::Line> links;
  for (size_t i = 0; i < closed; ++i) {
    const LoopPath& loop = graph.loops[i];
    KERF_ASSERT(!loop.points.empty());
    if (i + 1 == closed) {
      links_.draw(links, kLoopHalfWidth);
      links.clear();
    }
    const glm::vec4 colour = srgb(overlay_colours::kLoop, i + 1 == closed ? 1 : kEarlierLoop);
    const size_t sides = loop.points.size() - (loop.runs_around ? 0 : 1);
    const auto point = [&](size_t k) {
      const Vec3& read = loop.points[k % loop.points.size()];
      return subject.space.from_world(graph.moved_with(loop.body, read, subject.world));
    };
    for (size_t k = 0; k < sides; ++k) links.push_back({point(k), point(k + 1), colour});
  }
  links_.draw(links, 1.4f * kLoopHalfWidth);
}

void GraphPass::draw_lit_face(const Subject& subject) {
  const FaceOfBody lit = *subject.options.lit_face;
  if (!subject.world.contains(lit.body) || !subject.world.body(lit.body).mesh.is_live(lit.face)) return;
  const Body& body = subject.world.body(lit.body);
  const PieceLook look = BodyLooks(lit.body, body, subject.options).of(body.mesh, lit.face);
  if (look.hidden) return;
  const Triangle t = body.mesh.triangle(lit.face);
  const glm::vec4 colour = srgb(selection_colour(subject.options.tree.palette), 1);
  const auto corner = [&](size_t i) {
    return subject.space.from_world(look.turn * body.placement.to_world(t[i % 3]) + look.offset);
  };
  std::vector<ColouredLines::Line> sides;
  for (size_t i = 0; i < 3; ++i) sides.push_back({corner(i), corner(i + 1), colour});
  links_.draw(sides, 1.4f);
  draw_discs({{(corner(0) + corner(1) + corner(2)) / 3.0f, 4, colour}});
}

void GraphPass::draw_discs(const std::vector<Disc>& discs) {
  if (discs.empty()) return;
  discs_.send(discs);
  nodes_.use();
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, discs_.count());
}

}  // namespace kerf
