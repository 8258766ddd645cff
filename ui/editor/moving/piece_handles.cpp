#include "ui/editor/moving/piece_handles.h"

#include <imgui.h>

#include <cmath>

#include "core/base/angle.h"
#include "core/base/assert.h"
#include "ui/editor/moving/moving.h"
#include "ui/editor/shared/piece_set.h"
#include "ui/window/imgui_vector.h"
#include "ui/window/theme.h"

namespace kerf {

namespace {

constexpr double kArrowEms = 5.5, kRingEms = 4.2;  // length and radius
constexpr double kHandleReach = 7;                 // screen coordinates around a handle that belong to it
constexpr double kFreeFromEms = 1.2;  // around the pivot arrows are not taken: a click there picks
constexpr size_t kRingPoints = 64;
constexpr std::array kAxes{PieceMove::Axis::kX, PieceMove::Axis::kY, PieceMove::Axis::kZ};

std::optional<Vec3> pivot_shown(const ViewState& view, const std::optional<PieceMove>& move, bool picks,
                                const World& world) {
  if (move) {
    const PieceMove::Look look = move->look();
    return look.turn * move->pivot() + look.offset;
  }
  if (!picks || why_no_move(view.look.pieces) != nullptr) return std::nullopt;
  const PieceId piece = *first_chosen(view.look.pieces);
  const PieceLook& look = view.look.pieces.at(piece);
  return look.turn * pivot_of(world.body(piece.body), piece.label) + look.offset;
}

PieceHandle arrow(const HandleStage& stage, PieceMove::Axis axis) {
  const Vec3 tip = stage.pivot + direction_of(axis) * (kArrowEms * stage.em);
  return {PieceMove::Kind::kMove, axis, {stage.place_of(stage.pivot), stage.place_of(tip)}};
}

// The half in front is one run of points: it begins where the ring comes before the pivot.
PieceHandle ring(const HandleStage& stage, PieceMove::Axis axis) {
  const auto i = static_cast<int>(axis);
  Vec3 u(0), v(0);
  u[(i + 1) % 3] = v[(i + 2) % 3] = kRingEms * stage.em;
  const Vec3 towards = glm::normalize(stage.camera.eye - stage.pivot);
  const double middle = std::atan2(glm::dot(v, towards), glm::dot(u, towards));
  PieceHandle handle{PieceMove::Kind::kTurn, axis, {}};
  for (size_t k = 0; k <= kRingPoints; ++k) {
    const double angle = middle + kPi * (static_cast<double>(k) / kRingPoints - 0.5);
    handle.line.push_back(stage.place_of(stage.pivot + u * std::cos(angle) + v * std::sin(angle)));
  }
  return handle;
}

double distance_to_segment(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 along = b - a;
  const double length2 = glm::dot(along, along);
  const double t = length2 > 0 ? std::clamp(glm::dot(p - a, along) / length2, 0.0, 1.0) : 0;
  return glm::length(p - (a + along * t));
}

double distance_to(const PieceHandle& handle, Vec2 at) {
  double least = INFINITY;
  for (size_t i = 0; i + 1 < handle.line.size(); ++i)
    least = std::min(least, distance_to_segment(at, handle.line[i], handle.line[i + 1]));
  return least;
}

void draw_handle(const PieceHandle& handle, double em, bool pointed_at, ImDrawList& list) {
  const ImU32 colour =
      pointed_at ? colours::kPictureText : colours::kAxes.at(static_cast<size_t>(handle.axis));
  const bool is_arrow = handle.kind == PieceMove::Kind::kMove;
  std::vector<ImVec2> points;
  for (const Vec2& p : handle.line) points.push_back(to_im(p));
  // A dark rim under it, so that it is seen on every ground.
  const auto count = static_cast<int>(points.size());
  list.AddPolyline(points.data(), count, IM_COL32(10, 12, 16, 150), 0, is_arrow ? 5.0f : 4.0f);
  list.AddPolyline(points.data(), count, colour, 0, is_arrow ? 2.6f : 1.8f);
  if (!is_arrow) return;
  const Vec2 way = handle.line[1] - handle.line[0];
  if (glm::length(way) < 0.5 * em)
    return list.AddCircleFilled(points[1], static_cast<float>(0.3 * em), colour);
  const Vec2 along = glm::normalize(way) * (0.85 * em), across(-0.35 * along.y, 0.35 * along.x);
  const Vec2 tip = handle.line[1] + 0.5 * along;
  list.AddTriangleFilled(to_im(tip), to_im(tip - along + across), to_im(tip - along - across), colour);
}

// A long line through the pivot along the axis that the move keeps to.
void draw_axis(const HandleStage& stage, PieceMove::Axis axis, ImDrawList& list) {
  const Vec3 way = direction_of(axis) * (60 * stage.em);
  Vec3 ends[2] = {stage.pivot - way, stage.pivot + way};
  for (Vec3& end : ends) {
    for (int i = 0; i < 8 && stage.camera.project(end).z <= 0; ++i) end = 0.5 * (end + stage.pivot);
  }
  list.AddLine(to_im(stage.place_of(ends[0])), to_im(stage.place_of(ends[1])),
               colours::kAxes.at(static_cast<size_t>(axis)), 1.5f);
}

void draw_words(const HandleStage& stage, const std::string& words, ImDrawList& list) {
  constexpr const char* kKeys = "X Y Z: axis   0-9: amount   Enter or click: done   Esc or right click: back";
  const float em = ImGui::GetFontSize(), line = ImGui::GetTextLineHeight();
  const float width = std::max(ImGui::CalcTextSize(words.c_str()).x, ImGui::CalcTextSize(kKeys).x);
  const auto x = static_cast<float>(stage.area.at.x + 0.5 * stage.area.size.x) - 0.5f * width;
  const auto y = static_cast<float>(stage.area.at.y + stage.area.size.y) - 4 * em;
  list.AddRectFilled({x - em, y - 0.6f * em}, {x + width + em, y + 2.2f * line + 0.6f * em},
                     IM_COL32(0x1b, 0x1f, 0x26, 225), 3);
  list.AddText({x, y}, colours::kPictureText, words.c_str());
  list.AddText({x, y + 1.2f * line}, colours::kPictureSecondary, kKeys);
}

}  // namespace

Vec2 HandleStage::place_of(const Vec3& p) const {
  const Vec3 seen = camera.project(p);
  return area.at + Vec2(0.5 + 0.5 * seen.x, 0.5 - 0.5 * seen.y) * area.size;
}

std::optional<HandleStage> handle_stage(const ViewState& view, const std::optional<PieceMove>& move,
                                        bool picks, const World& world) {
  const auto pivot = pivot_shown(view, move, picks, world);
  if (!pivot) return std::nullopt;
  const CameraView camera = view.seen_first();
  const double depth = camera.project(*pivot).z;
  if (depth <= 0) return std::nullopt;
  const double pixel = 2 * depth * camera.tan_half_fov / view.layout.first.size.y;
  return HandleStage{camera, view.layout.first, *pivot, pixel * view.layout.em};
}

std::vector<PieceHandle> piece_handles(const std::optional<HandleStage>& stage) {
  std::vector<PieceHandle> handles;
  if (!stage) return handles;
  for (const PieceMove::Axis axis : kAxes) handles.push_back(ring(*stage, axis));
  for (const PieceMove::Axis axis : kAxes) handles.push_back(arrow(*stage, axis));
  return handles;
}

std::optional<PieceHandle> handle_under(const std::vector<PieceHandle>& handles, Vec2 at) {
  std::optional<PieceHandle> found;
  double least = kHandleReach;
  for (const PieceHandle& handle : handles) {
    const bool is_arrow = handle.kind == PieceMove::Kind::kMove;
    const Vec2 way = handle.line.back() - handle.line.front();
    if (is_arrow && glm::length(at - handle.line.front()) < kFreeFromEms / kArrowEms * glm::length(way))
      continue;
    const double distance = distance_to(handle, at);
    if (distance > least) continue;
    least = distance;
    found = handle;
  }
  return found;
}

std::string name_of(const PieceHandle& handle) {
  return std::string(handle.kind == PieceMove::Kind::kMove ? "move " : "turn ") +
         static_cast<char>('X' + static_cast<int>(handle.axis));
}

Vec2 grip_of(const PieceHandle& handle) {
  KERF_ASSERT(!handle.line.empty());
  if (handle.kind == PieceMove::Kind::kMove) return handle.line.back();
  return handle.line[handle.line.size() / 2];
}

void draw_piece_handles(const ViewState& view, const std::optional<HandleStage>& stage,
                        const std::optional<PieceMove>& move, Vec2 pointer, ImDrawList& list) {
  if (!stage) return;
  if (move) {
    if (move->axis()) draw_axis(*stage, *move->axis(), list);
    draw_words(*stage, move->words(std::string(unit_symbol(view.frame.unit)).c_str()), list);
    return;
  }
  const std::vector<PieceHandle> handles = piece_handles(stage);
  const auto under = handle_under(handles, pointer);
  for (const PieceHandle& handle : handles)
    draw_handle(handle, view.layout.em, under && name_of(*under) == name_of(handle), list);
}

}  // namespace kerf
