#include "ui/window/icons.h"

#include <array>

namespace kerf {

namespace {

// A plate with a slit, and the beam that cuts it.
void draw_cut(ImDrawList& list, ImVec2 m, float r, ImU32 colour) {
  list.AddLine({m.x + 0.9f * r, m.y - r}, {m.x, m.y + 0.25f * r}, colour, 2);
  list.AddLine({m.x - r, m.y + 0.45f * r}, {m.x - 0.25f * r, m.y + 0.45f * r}, colour, 2);
  list.AddLine({m.x + 0.35f * r, m.y + 0.45f * r}, {m.x + r, m.y + 0.45f * r}, colour, 2);
  for (const ImVec2& spark : {ImVec2(-0.5f, 0.95f), ImVec2(0.05f, 1), ImVec2(0.55f, 0.9f)})
    list.AddLine({m.x + 0.03f * r, m.y + 0.55f * r}, {m.x + spark.x * r, m.y + spark.y * r}, colour, 1);
}

void draw_eye(ImDrawList& list, ImVec2 m, float r, ImU32 colour) {
  list.AddBezierQuadratic({m.x - r, m.y}, {m.x, m.y - 1.25f * r}, {m.x + r, m.y}, colour, 1.5f);
  list.AddBezierQuadratic({m.x - r, m.y}, {m.x, m.y + 1.25f * r}, {m.x + r, m.y}, colour, 1.5f);
  list.AddCircleFilled(m, 0.32f * r, colour);
}

// Two crossed double arrows.
void draw_arrows(ImDrawList& list, ImVec2 m, float r, ImU32 colour) {
  for (const ImVec2& way : {ImVec2(1, 0), ImVec2(-1, 0), ImVec2(0, 1), ImVec2(0, -1)}) {
    const ImVec2 tip(m.x + way.x * r, m.y + way.y * r);
    list.AddLine(m, tip, colour, 1.5f);
    for (const float side : {-0.35f, 0.35f})
      list.AddLine(
          tip, {tip.x - 0.35f * r * way.x + side * r * way.y, tip.y - 0.35f * r * way.y + side * r * way.x},
          colour, 1.5f);
  }
}

void draw_thermometer(ImDrawList& list, ImVec2 m, float r, ImU32 colour) {
  const float half = 0.27f * r;
  list.AddRect({m.x - half, m.y - r}, {m.x + half, m.y + 0.45f * r}, colour, half, 0, 1.5f);
  list.AddCircleFilled({m.x, m.y + 0.6f * r}, 0.44f * r, colour);
  list.AddLine({m.x, m.y - 0.35f * r}, {m.x, m.y + 0.6f * r}, colour, 2);
  for (const float y : {-0.7f, -0.3f, 0.1f})
    list.AddLine({m.x + 0.5f * r, m.y + y * r}, {m.x + 0.85f * r, m.y + y * r}, colour, 1);
}

// A triangle, divided into smaller ones.
void draw_mesh(ImDrawList& list, ImVec2 m, float r, ImU32 colour) {
  const ImVec2 a(m.x - r, m.y + 0.8f * r), b(m.x + r, m.y + 0.8f * r), c(m.x, m.y - 0.9f * r);
  const auto middle = [](ImVec2 p, ImVec2 q) { return ImVec2(0.5f * (p.x + q.x), 0.5f * (p.y + q.y)); };
  list.AddTriangle(a, b, c, colour, 1.5f);
  list.AddTriangle(middle(a, b), middle(b, c), middle(c, a), colour, 1.5f);
}

void draw_pointer(ImDrawList& list, ImVec2 m, float r, ImU32 colour) {
  constexpr std::array<float, 14> kOutline{-0.6f, -1,    -0.6f, 0.7f,  -0.2f, 0.32f, 0.12f,
                                           1,     0.42f, 0.85f, 0.12f, 0.2f,  0.65f, 0.15f};
  std::array<ImVec2, kOutline.size() / 2> points{};
  for (size_t i = 0; i < points.size(); ++i)
    points.at(i) = {m.x + kOutline.at(2 * i) * r, m.y + kOutline.at(2 * i + 1) * r};
  list.AddPolyline(points.data(), static_cast<int>(points.size()), colour, ImDrawFlags_Closed, 1.5f);
}

// Two points, and the line between them with its ends.
void draw_callipers(ImDrawList& list, ImVec2 m, float r, ImU32 colour) {
  const ImVec2 a(m.x - 0.8f * r, m.y + 0.7f * r), b(m.x + 0.8f * r, m.y - 0.7f * r);
  list.AddLine(a, b, colour, 1.5f);
  for (const ImVec2& end : {a, b}) list.AddCircleFilled(end, 0.26f * r, colour);
}

void draw_ruler(ImDrawList& list, ImVec2 m, float r, ImU32 colour) {
  list.AddRect({m.x - r, m.y - 0.45f * r}, {m.x + r, m.y + 0.45f * r}, colour, 0, 0, 1.5f);
  for (int i = -2; i <= 2; ++i) {
    const float x = m.x + 0.36f * static_cast<float>(i) * r, length = i % 2 == 0 ? 0.45f : 0.28f;
    list.AddLine({x, m.y + 0.45f * r}, {x, m.y + (0.45f - length) * r}, colour, 1);
  }
}

void draw_path(ImDrawList& list, ImVec2 m, float r, ImU32 colour) {
  const ImVec2 a(m.x - 0.85f * r, m.y + 0.7f * r), b(m.x, m.y), c(m.x + 0.85f * r, m.y - 0.7f * r);
  list.AddBezierCubic(a, {a.x + 0.2f * r, a.y - 1.3f * r}, {c.x - 0.2f * r, c.y + 1.3f * r}, c, colour, 1.5f);
  for (const ImVec2& point : {a, b, c})
    list.AddRectFilled({point.x - 0.2f * r, point.y - 0.2f * r}, {point.x + 0.2f * r, point.y + 0.2f * r},
                       colour);
}

void draw_emitter(ImDrawList& list, ImVec2 m, float r, ImU32 colour) {
  list.AddRectFilled({m.x - 0.4f * r, m.y - r}, {m.x + 0.4f * r, m.y - 0.3f * r}, colour, 1.5f);
  list.AddLine({m.x, m.y - 0.3f * r}, {m.x, m.y + 0.8f * r}, colour, 1.5f);
  list.AddLine({m.x - r, m.y + 0.8f * r}, {m.x + r, m.y + 0.8f * r}, colour, 2);
}

void draw_section(ImDrawList& list, ImVec2 m, float r, ImU32 colour) {
  list.AddRect({m.x - 0.75f * r, m.y - 0.75f * r}, {m.x + 0.75f * r, m.y + 0.75f * r}, colour, 0, 0, 1.5f);
  list.AddLine({m.x - r, m.y + 0.6f * r}, {m.x + r, m.y - 0.6f * r}, colour, 2);
}

// Three quarters of a circle with an arrow head.
void draw_rotation(ImDrawList& list, ImVec2 m, float r, ImU32 colour) {
  list.PathArcTo(m, 0.8f * r, 0, 4.7f, 24);
  list.PathStroke(colour, 0, 1.5f);
  const ImVec2 tip(m.x + 0.45f * r, m.y - 0.8f * r);
  list.AddTriangleFilled({m.x, m.y - 1.2f * r}, tip, {m.x, m.y - 0.4f * r}, colour);
}

// A blade over the line that it cuts.
void draw_knife(ImDrawList& list, ImVec2 m, float r, ImU32 colour) {
  const auto at = [&](float x, float y) { return ImVec2(m.x + x * r, m.y + y * r); };
  list.AddLine(at(0.95f, -0.95f), at(0.4f, -0.4f), colour, 3);
  list.AddTriangle(at(0.4f, -0.4f), at(-0.85f, 0.55f), at(0.05f, 0.2f), colour, 1.5f);
  for (const float x : {-1.0f, -0.3f, 0.4f}) list.AddLine(at(x, 0.9f), at(x + 0.45f, 0.9f), colour, 1.5f);
}

}  // namespace

void draw_icon(Icon icon, ImDrawList& list, ImVec2 middle, float radius, ImU32 colour) {
  using Draw = void (*)(ImDrawList&, ImVec2, float, ImU32);
  constexpr std::array<Draw, 13> kDraws{
      draw_cut,   draw_eye,  draw_arrows,  draw_thermometer, draw_mesh,     draw_pointer, draw_callipers,
      draw_ruler, draw_path, draw_emitter, draw_section,     draw_rotation, draw_knife};
  static_assert(kDraws.size() == static_cast<size_t>(Icon::kKnife) + 1);
  kDraws.at(static_cast<size_t>(icon))(list, middle, radius, colour);
}

}  // namespace kerf
