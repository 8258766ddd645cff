#include "ui/editor/moving/piece_handles.h"

#include <imgui.h>

#include "ui/editor/moving/moving.h"
#include "ui/editor/shared/pieces/piece_set.h"
#include "ui/window/imgui_vector.h"
#include "ui/window/theme.h"

namespace kerf {

namespace {

constexpr double kArrowEms = 5.5, kRingEms = 4.2;  // length and radius
constexpr double kFreeFromEms = 1.2;  // around the pivot arrows are not taken: a click there picks
constexpr std::array kAxes{PieceMove::Axis::kX, PieceMove::Axis::kY, PieceMove::Axis::kZ};

char letter_of(PieceMove::Axis axis) { return static_cast<char>('X' + static_cast<int>(axis)); }

PieceHandle arrow(const FirstPicture& picture, const Vec3& pivot, PieceMove::Axis axis) {
  PieceHandle handle{{picture, std::string("move ") + letter_of(axis),
                      gizmo_arrow(picture, pivot, direction_of(axis), kArrowEms), 1},
                     PieceMove::Kind::kMove,
                     axis};
  handle.free_share = kFreeFromEms / kArrowEms;
  return handle;
}

PieceHandle ring(const FirstPicture& picture, const Vec3& pivot, PieceMove::Axis axis) {
  const auto i = static_cast<size_t>(axis);
  const Vec3 u = direction_of(kAxes.at((i + 1) % 3)), v = direction_of(kAxes.at((i + 2) % 3));
  return {{picture, std::string("turn ") + letter_of(axis), gizmo_ring(picture, pivot, u, v, kRingEms),
           kGizmoRing / 2},
          PieceMove::Kind::kTurn,
          axis};
}

// A long line through the pivot along the axis that the move keeps to.
void draw_axis(const FirstPicture& picture, const Vec3& pivot, PieceMove::Axis axis, ImDrawList& list) {
  const Vec3 way = direction_of(axis) * (60 * picture.metres_of_em(pivot));
  Vec3 ends[2] = {pivot - way, pivot + way};
  for (Vec3& end : ends) {
    for (int i = 0; i < 8 && !picture.place_of(end); ++i) end = 0.5 * (end + pivot);
  }
  const auto from = picture.place_of(ends[0]), to = picture.place_of(ends[1]);
  if (from && to) list.AddLine(to_im(*from), to_im(*to), colours::kAxes.at(static_cast<size_t>(axis)), 1.5f);
}

void draw_words(const Area& picture, const std::string& words, ImDrawList& list) {
  constexpr const char* kKeys = "X Y Z: axis   0-9: amount   Enter or click: done   Esc or right click: back";
  const float em = ImGui::GetFontSize(), line = ImGui::GetTextLineHeight();
  const float width = std::max(ImGui::CalcTextSize(words.c_str()).x, ImGui::CalcTextSize(kKeys).x);
  const auto x = static_cast<float>(picture.at.x + 0.5 * picture.size.x) - 0.5f * width;
  const auto y = static_cast<float>(picture.at.y + picture.size.y) - 4 * em;
  list.AddRectFilled({x - em, y - 0.6f * em}, {x + width + em, y + 2.2f * line + 0.6f * em},
                     IM_COL32(0x1b, 0x1f, 0x26, 225), 3);
  list.AddText({x, y}, colours::kPictureText, words.c_str());
  list.AddText({x, y + 1.2f * line}, colours::kPictureSecondary, kKeys);
}

// The point of pivot_shown(), wherever the eye is.
std::optional<Vec3> turned_about(const PieceMap& looks, const std::optional<PieceMove>& move, bool picks,
                                 const World& world) {
  if (move) {
    const PieceMove::Look look = move->look();
    return look.turn * move->pivot() + look.offset;
  }
  if (!picks || why_no_move(looks) != nullptr) return std::nullopt;
  const PieceId piece = *first_chosen(looks);
  const PieceLook& look = looks.at(piece);
  return look.turn * pivot_of(world.body(piece.body), piece.label) + look.offset;
}

}  // namespace

std::optional<Vec3> pivot_shown(const ViewState& view, const std::optional<PieceMove>& move, bool picks,
                                const World& world) {
  const auto pivot = turned_about(view.look.pieces, move, picks, world);
  return pivot && FirstPicture(view).place_of(*pivot) ? pivot : std::nullopt;
}

std::vector<PieceHandle> piece_handles(const ViewState& view, const std::optional<Vec3>& pivot) {
  std::vector<PieceHandle> handles;
  if (!pivot) return handles;
  const FirstPicture picture(view);
  for (const PieceMove::Axis axis : kAxes) handles.push_back(ring(picture, *pivot, axis));
  for (const PieceMove::Axis axis : kAxes) handles.push_back(arrow(picture, *pivot, axis));
  return handles;
}

void draw_piece_handles(const ViewState& view, const std::optional<Vec3>& pivot,
                        const std::optional<PieceMove>& move, Vec2 pointer, ImDrawList& list) {
  if (!pivot) return;
  if (move) {
    if (move->axis()) draw_axis(FirstPicture(view), *pivot, *move->axis(), list);
    draw_words(view.layout.first, move->words(std::string(unit_symbol(view.frame.unit)).c_str()), list);
    return;
  }
  const std::vector<PieceHandle> handles = piece_handles(view, pivot);
  const auto under = handle_under(handles, pointer);
  for (const PieceHandle& handle : handles) {
    const bool pointed_at = under && under->name == handle.name;
    draw_handle(handle, view.layout.em,
                pointed_at ? colours::kPictureText : colours::kAxes.at(static_cast<size_t>(handle.axis)),
                list);
  }
}

}  // namespace kerf
