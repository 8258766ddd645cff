#include "ui/render/passes/stage_pass.h"

#include "ui/gl/state.h"
#include "ui/render/bodies/body_looks.h"
#include "ui/render/view/overlay_colours.h"

namespace kerf {

namespace {

using Kind = StageMarks::Kind;

constexpr float kEdgeHalfWidth = 0.7f, kLastHalfWidth = 1.6f;  // pixels

float opacity_of_fill(Kind kind) {
  switch (kind) {
    case Kind::kSwept:
      return 0.07f;
    case Kind::kRemoved:
      return 0.34f;
    default:
      return 0.42f;
  }
}

float opacity_of_line(Kind kind) {
  switch (kind) {
    case Kind::kCulled:
      return 0.45f;
    case Kind::kEntered:
      return 0.6f;
    case Kind::kRemoved:
      return 0.7f;
    default:
      return 0.9f;
  }
}

// Places in the frame of a body, as they are drawn.
class DrawnAt {
 public:
  DrawnAt(const Subject& subject, BodyId id)
      : space_(subject.space), placement_(subject.world.body(id).placement), looks_(id, subject.options) {}

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

}  // namespace

StagePass::StagePass(Shaders& shaders)
    : fills_(shaders.load({{"frame.glsl", "line.glsl", "fill.vert"}, {"fill.frag"}})), lines_(shaders) {}

uint32_t colour_of(StageMarks::Kind kind) {
  switch (kind) {
    case Kind::kSwept:
      return overlay_colours::kSwept;
    case Kind::kHit:
      return overlay_colours::kHit;
    case Kind::kBorn:
      return overlay_colours::kBorn;
    case Kind::kRemoved:
      return overlay_colours::kRemoved;
    case Kind::kEntered:
      return overlay_colours::kEntered;
    case Kind::kCulled:
      return overlay_colours::kCulled;
    case Kind::kMissed:
      return overlay_colours::kMissed;
    case Kind::kTouched:
      return overlay_colours::kTouched;
    case Kind::kLast:
      break;
  }
  return overlay_colours::kLast;
}

void StagePass::draw(const Subject& subject) {
  if (!subject.options.stage) return;
  std::vector<Corner> corners;
  std::vector<ColouredLines::Line> lines, last;
  for (const StageMarks::OfBody& marks : subject.options.stage->bodies) {
    if (!subject.world.contains(marks.body)) continue;
    const DrawnAt at(subject, marks.body);
    for (const StageMarks::Fill& f : marks.fills) {
      if (at.hidden(f.piece)) continue;
      const glm::vec4 colour = srgb(colour_of(f.kind), opacity_of_fill(f.kind));
      for (const Vec3& corner : f.corners) corners.push_back({at(corner, f.piece), colour});
    }
    for (const StageMarks::Line& l : marks.lines) {
      if (at.hidden(l.piece)) continue;
      (l.kind == Kind::kLast ? last : lines)
          .push_back(
              {at(l.from, l.piece), at(l.to, l.piece), srgb(colour_of(l.kind), opacity_of_line(l.kind))});
    }
  }
  gl::ScopedState state({.writes_depth = false, .blend = gl::kOver});
  draw_fills(corners);
  lines_.draw(lines, kEdgeHalfWidth);
  state.set({.depth = GL_NONE, .blend = gl::kOver});
  lines_.draw(last, kLastHalfWidth);
}

void StagePass::draw_fills(const std::vector<Corner>& corners) {
  if (corners.empty()) return;
  corners_.send(corners);
  fills_.use();
  glDrawArrays(GL_TRIANGLES, 0, corners_.count());
}

}  // namespace kerf
