#include "ui/figures/split_diagram.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "core/base/assert.h"
#include "core/mesh/build_mesh.h"
#include "core/mesh/measures.h"
#include "core/mesh/refinement.h"

namespace kerf {

namespace {

constexpr double kSqrt3 = 1.7320508075688772;
constexpr size_t kSplits = 2;

constexpr ImU32 kBackground = IM_COL32(0xf4, 0xf5, 0xf7, 255), kStroke = IM_COL32(0x1b, 0x1f, 0x26, 255);
constexpr ImU32 kFace = IM_COL32(0xb9, 0xc9, 0xda, 255), kHit = IM_COL32(0xff, 0x9d, 0x2e, 255);
constexpr ImU32 kLine = IM_COL32(0x33, 0x41, 0x55, 255), kBeam = IM_COL32(0xd4, 0x2a, 0x1c, 255);

// A mesh of one triangle, split by the scheme.
class SplitTriangle {
 public:
  SplitTriangle() {
    Soup soup;
    for (const Vec2& corner : diagram_triangle()) soup.positions.emplace_back(corner.x, corner.y, 0);
    soup.triangles = {{0, 1, 2}};
    mesh_ = std::move(build_mesh(soup)->mesh);
  }

  // Returns the current elements and marks those that the beam intersects.
  std::vector<DiagramTriangle> triangles(const Vec2& beam, double radius) const {
    std::vector<DiagramTriangle> all;
    for (const FaceId f : elements()) all.push_back(drawn(f, beam, radius));
    return all;
  }

  void split_hit(const Vec2& beam, double radius) {
    std::vector<FaceId> hit;
    for (const FaceId f : elements()) {
      if (meets(scheme_.triangle(mesh_, f), beam, radius)) hit.push_back(f);
    }
    std::vector<Replacement> replacements;
    for (const FaceId f : hit) scheme_.split(mesh_, f, replacements);
  }

 private:
  static bool meets(const Triangle& t, const Vec2& beam, double radius) {
    return squared_distance({beam.x, beam.y, 0}, t) <= radius * radius;
  }

  // Returns one face of each element, by slot.
  std::vector<FaceId> elements() const {
    std::vector<FaceId> all;
    for (uint32_t i = 0; i < mesh_.face_slots(); ++i) {
      const FaceId f(i);
      if (!mesh_.is_live(f)) continue;
      const OneToFour::Element element = scheme_.element(mesh_, f);
      if (element.face_count == 1 || f == std::min(element.faces[0], element.faces[1])) all.push_back(f);
    }
    return all;
  }

  DiagramTriangle drawn(FaceId f, const Vec2& beam, double radius) const {
    const Triangle whole = scheme_.triangle(mesh_, f), face = mesh_.triangle(f);
    DiagramTriangle out;
    for (size_t i = 0; i < 3; ++i) out.corners[i] = Vec2(whole[i]);
    out.hit = meets(whole, beam, radius);
    for (const Vec3& p : face) {
      if (std::find(whole.begin(), whole.end(), p) == whole.end()) out.bisected = Vec2(p);
    }
    if (!out.bisected) return out;
    const auto off_middle = [&](size_t i) {
      return glm::length(0.5 * (out.corners[(i + 1) % 3] + out.corners[(i + 2) % 3]) - *out.bisected);
    };
    for (size_t i = 1; i < 3; ++i) {
      if (off_middle(i) < off_middle(out.corner)) out.corner = i;
    }
    return out;
  }

  Mesh mesh_;
  OneToFour scheme_;
};

// A panel of the diagram: the centre of its triangle in the image, and pixels per unit.
struct Panel {
  ImVec2 centre;
  float scale;
  ImVec2 at(const Vec2& p) const {
    return {centre.x + scale * static_cast<float>(p.x), centre.y - scale * static_cast<float>(p.y)};
  }
};

void draw_dashed(ImDrawList& list, ImVec2 from, ImVec2 to, ImU32 colour, float width) {
  const float dash = 0.35f * ImGui::GetFontSize();
  const float length = std::hypot(to.x - from.x, to.y - from.y);
  for (float s = 0; s < length; s += 2 * dash) {
    const float e = std::min(s + dash, length);
    list.AddLine({from.x + (to.x - from.x) * s / length, from.y + (to.y - from.y) * s / length},
                 {from.x + (to.x - from.x) * e / length, from.y + (to.y - from.y) * e / length}, colour,
                 width);
  }
}

void draw_triangle(ImDrawList& list, const Panel& panel, const DiagramTriangle& t, float width) {
  const ImVec2 a = panel.at(t.corners[0]), b = panel.at(t.corners[1]), c = panel.at(t.corners[2]);
  if (t.removed) {
    for (const auto& [from, to] : {std::pair{a, b}, {b, c}, {c, a}})
      draw_dashed(list, from, to, kBeam, width);
    return;
  }
  list.AddTriangleFilled(a, b, c, t.hit ? kHit : kFace);
  list.AddTriangle(a, b, c, kLine, width);
  if (t.bisected)
    draw_dashed(list, panel.at(t.corners[t.corner]), panel.at(*t.bisected), kLine, 0.6f * width);
}

void draw_panel(ImDrawList& list, const Panel& panel, const std::vector<DiagramTriangle>& stage,
                const Vec2& beam, double radius, const char* label) {
  const float width = std::max(1.5f, 0.11f * ImGui::GetFontSize());
  for (const bool removed : {true, false}) {
    for (const DiagramTriangle& t : stage) {
      if (t.removed == removed) draw_triangle(list, panel, t, width);
    }
  }
  list.AddCircle(panel.at(beam), panel.scale * static_cast<float>(radius), kBeam, 48, 1.6f * width);
  const ImVec2 size = ImGui::CalcTextSize(label);
  list.AddText({panel.centre.x - 0.5f * size.x, panel.centre.y + 0.72f * panel.scale}, kStroke, label);
}

void draw_arrow(ImDrawList& list, ImVec2 at) {
  const float em = ImGui::GetFontSize();
  list.AddLine({at.x - em, at.y}, {at.x + 0.6f * em, at.y}, kStroke, 0.14f * em);
  list.AddTriangleFilled({at.x + em, at.y}, {at.x + 0.4f * em, at.y - 0.4f * em},
                         {at.x + 0.4f * em, at.y + 0.4f * em}, kStroke);
}

}  // namespace

std::array<Vec2, 3> diagram_triangle() {
  return {Vec2(-1, -kSqrt3 / 3), {1, -kSqrt3 / 3}, {0, 2 * kSqrt3 / 3}};
}

std::vector<std::vector<DiagramTriangle>> split_stages(const Vec2& beam, double radius) {
  SplitTriangle triangle;
  std::vector<std::vector<DiagramTriangle>> stages{triangle.triangles(beam, radius)};
  for (size_t i = 0; i < kSplits; ++i) {
    triangle.split_hit(beam, radius);
    stages.push_back(triangle.triangles(beam, radius));
  }
  stages.push_back(stages.back());
  for (DiagramTriangle& t : stages.back()) t.removed = t.hit;
  return stages;
}

void draw_split_diagram() {
  static constexpr std::array kLabels{"The beam meets a triangle", "It is split into four",
                                      "What is hit is split again", "What is hit is removed"};
  const Vec2 beam(0.52, -0.33);
  const double radius = 0.13;
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  list.AddRectFilled({0, 0}, size, kBackground);
  const auto stages = split_stages(beam, radius);
  KERF_ASSERT(stages.size() == kLabels.size());
  const auto count = static_cast<float>(stages.size());
  const float scale = std::min(0.42f * size.x / count, 0.42f * size.y);
  for (size_t i = 0; i < stages.size(); ++i) {
    const float x = size.x * (static_cast<float>(i) + 0.5f) / count;
    draw_panel(list, {{x, 0.53f * size.y}, scale}, stages[i], beam, radius, kLabels[i]);
    if (i > 0) draw_arrow(list, {size.x * static_cast<float>(i) / count, 0.42f * size.y});
  }
}

}  // namespace kerf
