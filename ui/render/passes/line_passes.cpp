#include "ui/render/passes/line_passes.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/assert.h"
#include "ui/gl/draw_state.h"
#include "ui/render/bodies/body_picture.h"
#include "ui/render/view/colours.h"
#include "ui/render/view/frame_space.h"

namespace kerf {

namespace {

constexpr float kBoxFade = 0.80f;         // of the opacity, from one depth of the tree to the next
constexpr float kHitFade = 0.87f;         // the same for boxes hit by the beam
constexpr float kFaintest = 0.15f;        // fainter boxes are not drawn
constexpr float kFaintestAsked = 0.10f;   // minimum for boxes of a selected depth
constexpr float kFaintestHit = 0.13f;     // minimum for boxes hit by the beam
constexpr float kLeafFade = 0.97f;        // from one depth to the next if only leaves are drawn
constexpr float kDarkHalfWidth = 1.3f;    // pixels
constexpr float kColourHalfWidth = 0.6f;  // pixels
constexpr size_t kMaxBoxes = 3500;        // the largest on screen are drawn
constexpr GLsizei kMaxDark = 200;         // maximum number of lines with a dark outline
constexpr int kVerticesOfBox = 12 * 6;

// Deep boxes fade, to keep the structure of the tree readable; boxes of a selected depth are at least
// faintly visible.
float opacity_of(const AabbTree::Box& box, const TreeOverlay& tree) {
  const auto depth = static_cast<float>(box.depth);
  if (tree.leaves_only) return (box.hit ? 0.9f : 0.5f) * std::max(0.4f, std::pow(kLeafFade, depth));
  if (box.hit) return std::max(kFaintestHit, std::pow(kHitFade, depth));
  float opacity = std::pow(kBoxFade, depth);
  if (opacity < kFaintest) opacity = 0;
  return tree.deepest < TreeOverlay().deepest ? std::max(kFaintestAsked, opacity) : opacity;
}

// Draws each line twice: wide and dark, then thin in its colour.
void draw_twice(const gl::Program& program, const glm::mat4& from_body, int vertices, GLsizei instances,
                GLsizei max_dark, const glm::vec4& first, const glm::vec4& second, double scale) {
  if (instances == 0) return;
  program.use();
  program.set("frame_from_body", from_body);
  for (const bool dark : {true, false}) {
    program.set("half_width", static_cast<float>(scale) * (dark ? kDarkHalfWidth : kColourHalfWidth));
    program.set("hit_colour", dark ? glm::vec4(0.02f, 0.025f, 0.03f, 0.55f) : first);
    program.set("other_colour", dark ? glm::vec4(0.02f, 0.025f, 0.03f, 0.30f) : second);
    glDrawArraysInstanced(GL_TRIANGLES, 0, vertices, dark ? std::min(instances, max_dark) : instances);
  }
}

}  // namespace

LineOverlay::LineOverlay(Shaders& shaders)
    : box_(shaders.load({{"frame.glsl", "line.glsl", "box.vert"}, {"box.frag"}})),
      stick_(shaders.load({{"frame.glsl", "line.glsl", "stick.vert"}, {"box.frag"}})) {}

void LineOverlay::gather(Gathered& lines, const Body& body, const FloatFrame& frame,
                         const ViewOptions& options) const {
  TreeOverlay tree = options.tree;
  tree.hit_only = tree.hit_only || !options.show.aabb;
  if (options.show.aabb || options.show.aabb_hit) lines.all_boxes = gather_boxes(body, frame, tree);
  if (options.show.normals) lines.sticks.send(gather_normals(body, frame), GL_DYNAMIC_DRAW);
  lines.shown = options.show;
  lines.tree = options.tree;
}

std::vector<BoxLine> LineOverlay::gather_boxes(const Body& body, const FloatFrame& frame,
                                               const TreeOverlay& tree) const {
  std::vector<BoxLine> boxes;
  body.tree.for_each_box(body.mesh, [&](const AabbTree::Box& box) {
    if ((tree.hit_only && !box.hit) || box.depth > tree.deepest || (tree.leaves_only && !box.leaf)) return;
    const float opacity = opacity_of(box, tree);
    if (opacity <= 0) return;
    boxes.push_back({frame.to_float(box.min), frame.to_float(box.max), {box.hit ? 1.0f : 0.0f, opacity}});
  });
  return boxes;
}

std::vector<LineOverlay::Stick> LineOverlay::gather_normals(const Body& body, const FloatFrame& frame) const {
  std::vector<Stick> sticks;
  for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
    if (!body.mesh.is_live(FaceId(f))) continue;
    const Triangle t = body.mesh.triangle(FaceId(f));
    const glm::dvec3 a = frame.scaled(t[0]), b = frame.scaled(t[1]), c = frame.scaled(t[2]);
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    const double twice_area = glm::length(normal);
    if (!(twice_area > 0)) continue;
    const glm::dvec3 middle = (a + b + c) / 3.0;
    const double length = std::min(0.6 * std::sqrt(twice_area), 0.03);
    sticks.push_back({glm::vec3(middle), glm::vec3(middle + normal * (length / twice_area))});
  }
  return sticks;
}

void LineOverlay::draw(BodyId id, const Body& body, const FloatFrame& frame, const FrameSpace& space,
                       const glm::mat4& clip_from_frame, const ViewOptions& options) {
  const ShowOptions& show = options.show;
  const bool boxes = (show.aabb || show.aabb_hit) && options.tree.body.value_or(id) == id;
  if (!boxes && !show.normals) return;
  const auto [found, fresh] = gathered_.try_emplace(id);
  Gathered& lines = found->second;
  if (fresh || !(lines.shown == show && lines.tree == options.tree)) gather(lines, body, frame, options);
  const glm::mat4 from_body = space.from_body(body.placement, frame);
  const gl::ScopedState state({.writes_depth = false, .blend = gl::kOver});
  if (boxes) {
    lines.boxes.send(select_boxes(lines.all_boxes, clip_from_frame * from_body, kMaxBoxes), GL_DYNAMIC_DRAW);
    const BoxColours colours = colours_of(options.tree.palette);
    draw_twice(box_, from_body, kVerticesOfBox, lines.boxes.count(), kMaxDark, srgb(colours.hit, 1),
               srgb(colours.untouched, 1), options.mark_scale);
  }
  if (show.normals) {
    const SectionClip clip(options);
    lines.sticks.bind();
    draw_twice(stick_, from_body, kVerticesOfLine, lines.sticks.count(), lines.sticks.count(),
               srgb(0x4aa3ff, 0.9f), glm::vec4(0), options.mark_scale);
  }
}

namespace {

constexpr float kWireHalfWidth = 0.6f, kDarkWireHalfWidth = 1.2f;  // pixels
// Edges at least this long in the frame are opaque; shorter ones fade, so that a fine wire does not hide
// the surface.
constexpr float kPlainEdge = 16, kMinOpacity = 0.12f;  // pixels
constexpr float kEdgeWithDark = 5;                     // pixels; shorter edges have no dark outline

// Returns the usual length of a part's edges in the frame at the middle of the part, in pixels of a frame
// of usual height.
float pixels_of_edge(const DrawnWire::Part& part, const glm::mat4& from_part, const FrameSpace& space,
                     const FrameUniforms& frame) {
  const glm::mat4& m = frame.clip_from_frame;
  const glm::vec4 middle = m * from_part * glm::vec4(0, 0, 0, 1);
  const float height = glm::length(glm::vec3(m[0].y, m[1].y, m[2].y)) / std::max(middle.w, 1e-6f);
  return space.length(part.mean_edge) * height * 0.5f * std::min(frame.viewport.y, 900.0f);
}

}  // namespace

WirePass::WirePass(Shaders& shaders)
    : program_(shaders.load({{"frame.glsl", "line.glsl", "stick.vert"}, {"box.frag"}})) {}

void WirePass::send(std::shared_ptr<const DrawnWire> wire) {
  if (sent_ == wire) return;
  sent_ = std::move(wire);
  edges_.clear();
  if (!sent_) return;
  for (const DrawnWire::Part& part : sent_->parts) {
    Edges& edges = edges_.emplace_back(
        gl::ItemsAre::kInstances,
        std::vector<Edges::Floats>{{3, offsetof(DrawnWire::Edge, from)}, {3, offsetof(DrawnWire::Edge, to)}});
    edges.send(part.edges, GL_STATIC_DRAW);
  }
}

void WirePass::draw(const Subject& subject, const FrameUniforms& frame) {
  send(subject.options.wire);
  if (!sent_) return;
  const gl::ScopedState state({.writes_depth = false, .blend = gl::kOver});
  const SectionClip clip(subject.options);
  const auto scale = static_cast<float>(subject.options.mark_scale);
  program_.use();
  program_.set("pulled", subject.space.length(sent_->depth));
  for (size_t i = 0; i < edges_.size(); ++i) {
    const DrawnWire::Part& part = sent_->parts[i];
    const auto found = subject.options.pieces.find(part.piece);
    const PieceLook look = found != subject.options.pieces.end() ? found->second : PieceLook();
    if (look.hidden) continue;
    const glm::mat4 from_part = subject.space.from_body({look.offset, look.turn}, part.frame);
    const float pixels = pixels_of_edge(part, from_part, subject.space, frame);
    const float opacity = std::clamp(pixels / kPlainEdge, kMinOpacity, 1.0f);
    program_.set("frame_from_body", from_part);
    edges_[i].bind();
    for (const bool dark : {true, false}) {
      if (dark && pixels < kEdgeWithDark) continue;
      program_.set("half_width", scale * (dark ? kDarkWireHalfWidth : kWireHalfWidth));
      program_.set("hit_colour", dark ? glm::vec4(0.02f, 0.025f, 0.03f, 0.4f * opacity)
                                      : srgb(overlay_colours::kPreview, 0.8f * opacity));
      glDrawArraysInstanced(GL_TRIANGLES, 0, kVerticesOfLine, edges_[i].count());
    }
  }
}

namespace {

constexpr float kSectionWidth = 1.5f;  // see scaled_width

}  // namespace

SectionPass::SectionPass(Shaders& shaders)
    : line_(shaders.load({{"frame.glsl", "placed.glsl", "section.vert"}, {"section.frag"}})) {}

void SectionPass::draw(const Subject& subject, int height) const {
  if (shown_section(subject.options) == nullptr) return;
  KERF_ASSERT(is_frame_bound());
  const SectionClip clip(subject.options);
  const gl::ScopedState state(
      {.depth = GL_EQUAL, .writes_depth = false, .culled = subject.culled(), .blend = gl::kOver});
  line_.use();
  line_.set("wide", scaled_width(kSectionWidth, height));
  draw_bodies(subject, line_);
}

}  // namespace kerf
