#include "ui/render/passes/wire_pass.h"

#include <algorithm>
#include <utility>

#include "ui/gl/state.h"
#include "ui/render/view/overlay_colours.h"
#include "ui/render/view/section_clip.h"

namespace kerf {

namespace {

constexpr float kWireHalfWidth = 0.6f, kDarkWireHalfWidth = 1.2f;  // pixels
// Edges as long as these in the picture are drawn fully; shorter ones fade, so that a fine wire leaves the
// surface in sight.
constexpr float kPlainEdge = 16, kLeastOpacity = 0.12f;  // pixels
constexpr float kEdgeWithDark = 5;                       // pixels; shorter edges have no room for a dark one

// The length of the usual edge of a part in the picture where the middle of the part is, in pixels of a
// picture of usual height.
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
    const float opacity = std::clamp(pixels / kPlainEdge, kLeastOpacity, 1.0f);
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

}  // namespace kerf
