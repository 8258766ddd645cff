#include "ui/render/passes/coloured_lines.h"

#include "core/base/assert.h"

namespace kerf {

namespace {

constexpr float kDarkAround = 0.8f;  // pixels

}  // namespace

ColouredLines::ColouredLines(Shaders& shaders)
    : program_(shaders.load({{"frame.glsl", "line.glsl", "link.vert"}, {"box.frag"}})) {}

// Dark ones first, a little wider.
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

}  // namespace kerf
