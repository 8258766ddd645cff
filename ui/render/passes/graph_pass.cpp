#include "ui/render/passes/graph_pass.h"

#include <algorithm>
#include <array>
#include <map>

#include "core/base/assert.h"
#include "ui/gl/state.h"
#include "ui/render/bodies/body_looks.h"
#include "ui/render/view/box_palette.h"
#include "ui/render/view/overlay_colours.h"
#include "ui/render/view/scaled_width.h"
#include "ui/render/view/section_clip.h"

namespace kerf {

namespace {

constexpr float kLinkHalfWidth = 0.7f;                        // pixels
constexpr float kLoopHalfWidth = 1.1f, kEarlierLoop = 0.45f;  // pixels; opacity
constexpr float kLeastRadius = 1.6f, kMostRadius = 7;         // of a disc, pixels
constexpr float kRadiusOfLink = 0.22f;                        // of the usual length of a link

// Where nodes are drawn: moved with their bodies, displaced with their pieces, and not at all where these are
// hidden.
class Places {
 public:
  Places(const Subject& subject, const DrawnGraph& graph) : subject_(subject), graph_(graph) {}

  std::optional<glm::vec3> of(const DrawnGraph::Node& node) {
    const Vec3 middle = graph_.moved_with(node.face.body, node.middle, subject_.world);
    const glm::vec3 at = subject_.space.from_world(middle);
    if (node.removed || !is_live(node.face)) return at;
    const BodyId id = node.face.body;
    const auto found = looks_.try_emplace(id, id, subject_.options).first;
    const PieceLook& look = found->second.of(subject_.world.body(id).mesh, node.face.face);
    if (look.hidden) return std::nullopt;
    return at + glm::vec3(subject_.space.turned(look.offset) / subject_.space.unit);
  }

 private:
  bool is_live(const GraphNode& n) const {
    return subject_.world.contains(n.body) && subject_.world.body(n.body).mesh.is_live(n.face);
  }

  const Subject& subject_;
  const DrawnGraph& graph_;
  std::map<BodyId, BodyLooks> looks_;
};

// The length that half of the links exceed in the picture, in pixels of a picture of usual height.
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
  const float radius = std::clamp(kRadiusOfLink * usual_length(ends, frame), kLeastRadius, kMostRadius);
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

// The last one that is closed by then over the others.
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
  const PieceLook look = BodyLooks(lit.body, subject.options).of(body.mesh, lit.face);
  if (look.hidden) return;
  const Triangle t = body.mesh.triangle(lit.face);
  const glm::vec4 colour = srgb(selection_colour(subject.options.tree.palette), 1);
  const auto corner = [&](size_t i) {
    return subject.space.from_world(body.placement.to_world(t[i % 3]) + look.offset);
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
