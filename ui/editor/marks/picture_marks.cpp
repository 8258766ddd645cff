#include "ui/editor/marks/picture_marks.h"

#include <imgui.h>

#include "ui/editor/inspect/face_readout.h"
#include "ui/editor/marks/hint_box.h"
#include "ui/editor/marks/legends.h"
#include "ui/editor/marks/play_marks.h"
#include "ui/editor/marks/stage_caption.h"
#include "ui/editor/path/path_marks.h"
#include "ui/editor/section/section_handles.h"
#include "ui/editor/tools/axes_gizmo.h"
#include "ui/editor/tools/light_handle.h"
#include "ui/editor/tools/piece_handles.h"
#include "ui/editor/tools/rubber_band.h"
#include "ui/editor/view/file_frames.h"
#include "ui/render/pick.h"
#include "ui/window/imgui_vector.h"
#include "ui/window/number_text.h"
#include "ui/window/theme.h"

namespace kerf {

namespace {

constexpr double kLeastRing = 3, kMostRing = 400;  // pixels

// As large as the cut would be where the pointer is.
void draw_ring(const MarkParts& of, ImDrawList& list) {
  if (!of.hand.over_picture && of.hand.drag != Drag::kCut) return;
  if (of.hand.tool != Tool::kLaser && of.hand.drag != Drag::kCut) return;
  if (of.hand.drag != Drag::kNone && of.hand.drag != Drag::kCut) return;
  if (of.hand.drag == Drag::kNone && is_on_axes(of.view, of.hand.pointer)) return;
  const CameraView view = of.view.seen();
  const Vec2 p = of.view.in_picture(of.hand.pointer);
  const auto seen_face = pick(of.document.world(), of.view.look, view.ray(p.x, p.y));
  const double distance = seen_face ? seen_face->length : view.focus;
  const double seen = view.parallel ? view.half_height() : distance * view.tan_half_fov;
  const double pixels = of.hand.laser.radius / seen * 0.5 * of.view.pane().size.y;
  const auto ring = static_cast<float>(std::clamp(pixels, kLeastRing, kMostRing));
  const ImVec2 at = to_im(of.hand.pointer);
  list.AddCircle(at, ring + 1.5f, IM_COL32(10, 12, 16, 150), 0, 3.0f);
  list.AddCircle(at, ring + 1.5f, of.hand.drag == Drag::kCut ? colours::accent() : colours::kPictureText, 0,
                 1.3f);
}

std::string resolution_text(const Resolution& r, FileUnit unit) {
  if (r.rule == Resolution::Rule::kTargetEdge) return "Edges of " + length_label(r.target_edge, unit);
  if (r.rule == Resolution::Rule::kTolerance) return "Within " + length_label(r.tolerance, unit);
  return r.depth == 0 ? "Whole faces" : "Depth " + std::to_string(r.depth);
}

// What a half shows, in its upper left corner.
void draw_half_label(const Area& half, const std::string& what, const std::string& faces, ImDrawList& list) {
  const float em = ImGui::GetFontSize(), line = ImGui::GetTextLineHeight();
  const float x = static_cast<float>(half.at.x) + em, y = static_cast<float>(half.at.y) + em;
  const float width = std::max(ImGui::CalcTextSize(what.c_str()).x, ImGui::CalcTextSize(faces.c_str()).x);
  list.PushClipRect(to_im(half.at), to_im(half.at + half.size), true);
  list.AddRectFilled({x - 0.6f * em, y - 0.4f * em}, {x + width + 0.6f * em, y + 2.2f * line + 0.4f * em},
                     colours::kPictureShade, 3);
  list.AddText({x, y}, colours::kPictureText, what.c_str());
  list.AddText({x, y + 1.2f * line}, colours::kPictureSecondary, faces.c_str());
  list.PopClipRect();
}

void draw_half_labels(const MarkParts& of, ImDrawList& list) {
  const Layout& l = of.view.layout;
  if (!l.split()) return;
  const bool cut = of.document.strokes() > 0;
  const double radius = of.hand.laser.radius;
  const SplitView& split = of.split;
  draw_half_label(
      l.first,
      resolution_text(cut ? of.document.stroke_settings().resolution : of.hand.laser.resolution.of(radius),
                      of.view.frame.unit),
      grouped(of.shown.faces) + " faces", list);
  const bool there = split.twin.there();
  draw_half_label(
      l.second,
      resolution_text(cut ? split.twin.resolution() : split.resolution.of(radius), of.view.frame.unit),
      there ? grouped(of.shown.twin_faces) + " faces" : "Too large to be cut twice (more than 400 000 faces)",
      list);
  const auto x = static_cast<float>(l.second.at.x), y = static_cast<float>(l.second.at.y);
  list.AddLine({x, y}, {x, y + static_cast<float>(l.second.size.y)}, colours::kPictureShade, 3);
  list.AddLine({x, y}, {x, y + static_cast<float>(l.second.size.y)}, colours::kPictureSecondary, 1);
}

// The path while it is in hand or its panel is unfolded, and the emitter.
void draw_placed_lasers(const MarkParts& of, bool cutting, ImDrawList& list) {
  const FirstPicture picture(of.view);
  const Area& first = of.view.layout.first;
  list.PushClipRect(to_im(first.at), to_im(first.at + first.size), true);
  if (shows_path(of.hand, of.settings) && !cutting)
    draw_path(of.lasers.path, of.document.world(), picture, list);
  draw_emitter(of.lasers.emitter, picture, of.hand.over_picture ? of.hand.pointer : Vec2(-1), list);
  list.PopClipRect();
}

// The first half without the label in its corner.
Area under_label(const Layout& l) {
  const Vec2 label(0, l.split() ? 2.2 * ImGui::GetTextLineHeight() + ImGui::GetFontSize() : 0);
  return {l.first.at + label, l.first.size - label};
}

}  // namespace

void draw_picture_marks(const MarkParts& of) {
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const Area& area = of.view.layout.viewport;
  list.PushClipRect(to_im(area.at), to_im(area.at + area.size));
  draw_ring(of, list);
  draw_half_labels(of, list);
  draw_axes_gizmo(of.view, of.hand.over_picture ? of.hand.pointer : Vec2(-1), list);
  const bool cutting = of.hand.drag == Drag::kCut || of.document.beam_waits();
  if (shows_light_handles(of.settings) && !cutting) draw_light_handles(of.view, list);
  draw_placed_lasers(of, cutting, list);
  const bool free = of.hand.over_picture && of.hand.drag == Drag::kNone;
  if (!cutting)
    draw_section(of.view, of.document.world().bounds(), free ? std::optional(of.hand.pointer) : std::nullopt,
                 of.hand.section, list);
  if (!cutting) draw_piece_handles(of.view, of.hand, of.document.world(), list);
  draw_face_readout(of.view, of.hand, of.document.world(), list);
  draw_heat_probe(of.probe, of.view.layout.first);
  draw_spring(of.document.world(), of.view, of.hand);
  draw_play_badge(of.play, of.document.world(), of.view);
  if (of.hand.drag == Drag::kBox) draw_rubber_band({of.hand.pressed_at, of.hand.pointer}, list);
  const Area legends = draw_legends(legends_of(of.view.look, of.shadows), under_label(of.view.layout));
  const bool steps = of.stages.wishes.on && of.stages.log.done() > 0;
  if (steps) draw_stage_caption(of.stages.log, of.view.layout.first);
  if (!steps && !of.hand.cut_once && of.hand.tool == Tool::kLaser && !of.hand.move)
    draw_hint_box(of.document.world(), of.view, legends);
  list.PopClipRect();
}

}  // namespace kerf
