#include "ui/render/passes/stage_pass.h"

#include <array>

#include "ui/gl/state.h"
#include "ui/render/bodies/body_looks.h"
#include "ui/render/view/overlay_colours.h"

namespace kerf {

namespace {

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
                                 StageLook{overlay_colours::kBorn},
                                 StageLook{overlay_colours::kRemoved, 0.34f, 0.7f},
                                 StageLook{.colour = overlay_colours::kEntered, .line = 0.6f},
                                 StageLook{.colour = overlay_colours::kCulled, .line = 0.45f},
                                 StageLook{overlay_colours::kMissed},
                                 StageLook{overlay_colours::kTouched},
                                 StageLook{overlay_colours::kLast}};
static_assert(kStageLooks.size() == static_cast<size_t>(Kind::kLast) + 1);

const StageLook& stage_look(Kind kind) { return kStageLooks[static_cast<size_t>(kind)]; }

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
