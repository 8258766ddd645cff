#include "ui/editor/tools/viewport_input.h"

#include <GLFW/glfw3.h>

#include <cmath>

#include "core/base/assert.h"
#include "ui/editor/path/surface_point.h"
#include "ui/editor/play/pulling.h"
#include "ui/editor/section/section_handles.h"
#include "ui/editor/tools/axes_gizmo.h"
#include "ui/editor/tools/click.h"
#include "ui/editor/tools/light_handle.h"
#include "ui/editor/tools/moving.h"
#include "ui/editor/tools/piece_handles.h"
#include "ui/editor/tools/rubber_band.h"
#include "ui/editor/view/file_frames.h"
#include "ui/editor/view/piece_set.h"
#include "ui/render/pick.h"
#include "ui/render/spread.h"

namespace kerf {

namespace {

constexpr double kOrbitPerHeight = 3.6;  // radians for a drag over the height of the picture
constexpr double kZoomPerNotch = 0.88;

Drag drag_of(Tool tool, int button, int mods) {
  const bool shift = (mods & GLFW_MOD_SHIFT) != 0, alt = (mods & GLFW_MOD_ALT) != 0;
  switch (button) {
    case GLFW_MOUSE_BUTTON_LEFT:
      if (alt) return Drag::kOrbit;
      if (tool == Tool::kInspect && (mods & GLFW_MOD_CONTROL) == 0) return Drag::kMeasure;
      if (tool == Tool::kPath && (mods & GLFW_MOD_CONTROL) == 0) return Drag::kPath;
      return tool == Tool::kPick || (mods & GLFW_MOD_CONTROL) != 0 ? Drag::kPick : Drag::kCut;
    case GLFW_MOUSE_BUTTON_MIDDLE:
      return shift ? Drag::kPan : Drag::kOrbit;
    case GLFW_MOUSE_BUTTON_RIGHT:
      return Drag::kPan;
    default:
      return Drag::kNone;
  }
}

// The beam cuts pieces where they stand, so they are drawn there.
void stand_together(const MouseParts& on) {
  if (on.view.spread == 0) return;
  on.view.spread = 0;
  spread_pieces(on.work.document.world(), 0, on.view.look);
}

void pick_piece(const MouseParts& on, int mods) {
  if (on.view.in_second) return on.message.say("Pieces are chosen in the left half.", true);
  const Vec2 p = on.view.in_picture(on.hand.pointer);
  const World& world = on.work.document.world();
  const std::optional<Pick> seen = pick(world, on.view.look, on.view.seen().ray(p.x, p.y));
  const bool add = (mods & GLFW_MOD_SHIFT) != 0;
  if (seen) {
    choose_piece(on.view.look.pieces, {seen->body, world.body(seen->body).mesh.data(seen->face).piece}, add);
  } else if (!add) {
    choose_none(on.view.look.pieces);
  }
  on.view.picture_old = true;
}

// The third click begins another distance.
void measure_point(const MouseParts& on) {
  if (on.view.in_second) return on.message.say("Distances are measured in the left half.", true);
  const Vec2 p = on.view.in_picture(on.hand.pointer);
  const Pose ray = on.view.seen().ray(p.x, p.y);
  const std::optional<Pick> seen = pick(on.work.document.world(), on.view.look, ray);
  if (!seen) return on.message.say("There is no surface under the pointer.", true);
  std::vector<Vec3>& points = on.hand.measured;
  if (points.size() == 2) points.clear();
  points.push_back(ray.origin + ray.direction * seen->length);
  if (points.size() < 2) return on.message.say("Click a second point to measure its distance from this one.");
  const Vec3 way = points[1] - points[0];
  const auto text = [&](double length) { return length_label(length, on.view.frame.unit); };
  on.message.say("Distance " + text(glm::length(way)) + "; along X " + text(std::abs(way.x)) + ", along Y " +
                 text(std::abs(way.y)) + ", along Z " + text(std::abs(way.z)));
}

void choose_in_box(const MouseParts& on, int mods) {
  if (on.view.in_second) return on.message.say("Pieces are chosen in the left half.", true);
  PieceMap& looks = on.view.look.pieces;
  if ((mods & GLFW_MOD_SHIFT) == 0) choose_none(looks);
  const RubberBand band{on.view.in_picture(on.hand.pressed_at), on.view.in_picture(on.hand.pointer)};
  for (const PieceId& id : pieces_in(band, on.work.document.world(), on.view.look, on.view.seen()))
    looks[id].selected = true;
  on.view.picture_old = true;
}

// Begins to move the chosen piece by the handle under the pointer. Returns whether there is one.
bool take_handle(const MouseParts& on) {
  const World& world = on.work.document.world();
  const auto handle = handle_under(piece_handles(on.view, on.hand, world), on.hand.pointer);
  if (!handle) return false;
  begin_move(on.hand, on.view, world, handle->kind);
  on.hand.move->constrain(handle->axis);
  on.hand.drag = Drag::kPiece;
  return true;
}

void press_path(const MouseParts& on, int mods) {
  if (on.view.in_second) return on.message.say("The path is drawn in the left half.", true);
  stand_together(on);
  const World& world = on.work.document.world();
  const bool new_stroke = (mods & GLFW_MOD_SHIFT) != 0;
  on.message.say("");
  const std::string why =
      on.lasers.path_tool.press(on.lasers.path, world, on.view, on.hand.pointer, new_stroke,
                                PathTool::beam_for(world, on.hand.laser.radius));
  if (!why.empty()) on.message.say(why, true);
}

// Begins to drag the part of the emitter under the pointer. Returns whether there is one.
bool take_emitter(const MouseParts& on) {
  const auto handles = emitter_handles(on.lasers.emitter, FirstPicture(on.view));
  const auto handle = emitter_handle_under(handles, on.hand.pointer);
  if (!handle || on.view.in_second) return false;
  on.lasers.emitter.take(*handle, on.hand.pointer);
  on.hand.drag = Drag::kEmitter;
  return true;
}

// The beam of an emitter that fires follows each move of the pointer, as that of the pointer itself does.
void drag_emitter(const MouseParts& on, double heard) {
  Emitter& emitter = on.lasers.emitter;
  const FirstPicture picture(on.view);
  const auto surface = surface_point(on.work.document.world(), on.view.look, picture.ray(on.hand.pointer));
  emitter.drag(picture, on.hand.pointer, surface ? std::optional(surface->at) : std::nullopt);
  if (emitter.drawing) on.hand.beam.carry_to(on.work.document, emitter.pose(), heard);
}

// Begins to cut.
void press_laser(const MouseParts& on, double heard) {
  if (on.loader.busy()) {
    on.hand.drag = Drag::kNone;
    return on.message.say("The laser waits until " + on.loader.order().name() + " is open.");
  }
  stand_together(on);
  cancel_stroke(on.hand, on.work.document);
  on.hand.drag = Drag::kCut;
  on.lasers.emitter.firing = on.lasers.emitter.drawing = false;
  on.view.camera.finish();
  on.hand.beam.press(on.work.document, on.view.seen(), on.view.in_picture(on.hand.pointer), on.hand.laser,
                     heard);
  on.hand.cut_once = true;
  on.message.say("");
}

void begin(const MouseParts& on, Drag drag, const InputEvent& event) {
  on.hand.drag = drag;
  on.hand.pressed_at = on.hand.pointer;
  const bool left =
      drag == Drag::kCut || drag == Drag::kPick || drag == Drag::kMeasure || drag == Drag::kPath;
  if (left && is_on_axes(on.view, on.hand.pointer)) {
    on.hand.drag = Drag::kAxes;
    return;
  }
  if (left) {
    const auto light = light_under(on.view, on.hand.pointer);
    if (light && shows_light_handles(on.settings)) {
      on.hand.drag = Drag::kLight;
      on.hand.dragged_light = *light;
      return;
    }
    on.hand.section = section_drag_at(on.view, on.hand.pointer);
    if (on.hand.section) {
      on.hand.drag = Drag::kSection;
      return;
    }
  }
  if (left && take_emitter(on)) return;
  on.hand.spring.reset();
  if (drag == Drag::kPick && take_handle(on)) return;
  if (drag == Drag::kPick && on.play.playing)
    on.hand.spring = spring_at(on.work.document.world(), on.view, on.hand.pointer);
  if (drag == Drag::kPath) press_path(on, event.mods);
  if (drag == Drag::kCut) press_laser(on, event.seconds);
}

// Whether the pointer moved too far for a click.
bool has_left_click(const Hand& hand) { return glm::length(hand.pointer - hand.pressed_at) > kClickReach; }

// What was pressed while time passes is pulled; otherwise the pieces in a box are chosen.
void leave_click(const MouseParts& on) {
  const bool pulls = on.hand.spring && on.play.playing;
  on.hand.drag = pulls ? Drag::kPull : Drag::kBox;
  if (pulls) stretch(*on.hand.spring, on.view, on.hand.pointer);
}

void go_on(const MouseParts& on, Vec2 from, double heard) {
  const Vec2 moved = (on.hand.pointer - from) / on.view.pane().size.y;
  switch (on.hand.drag) {
    case Drag::kCut:
      on.hand.beam.move(on.work.document, on.view.seen(), on.view.in_picture(on.hand.pointer),
                        2 / on.view.pane().size.y, heard);
      break;
    case Drag::kPick:
      if (has_left_click(on.hand)) leave_click(on);
      break;
    case Drag::kAxes:
      if (has_left_click(on.hand)) on.hand.drag = Drag::kOrbit;
      break;
    case Drag::kOrbit:
      on.view.camera.orbit(-moved.x * kOrbitPerHeight * on.settings.drag_speed,
                           moved.y * kOrbitPerHeight * on.settings.drag_speed);
      break;
    case Drag::kPan:
      on.view.camera.pan(2 * moved.x / on.view.aspect(), -2 * moved.y, on.view.aspect());
      break;
    case Drag::kLight:
      drag_light(on.view, on.hand.dragged_light, on.hand.pointer);
      break;
    case Drag::kPiece:
      if (on.hand.move) follow_move(on.hand, on.view);
      break;
    case Drag::kPath:
      on.lasers.path_tool.move(on.lasers.path, on.work.document.world(), on.view, on.hand.pointer);
      break;
    case Drag::kEmitter:
      drag_emitter(on, heard);
      break;
    case Drag::kSection:
      KERF_ASSERT(on.hand.section);
      on.view.look.section = on.hand.section->to(on.view.in_picture(on.hand.pointer));
      on.view.picture_old = true;
      break;
    case Drag::kPull:
      if (on.hand.spring) stretch(*on.hand.spring, on.view, on.hand.pointer);
      break;
    case Drag::kMeasure:
    case Drag::kBox:
    case Drag::kNone:
      break;
  }
}

void end(const MouseParts& on, const InputEvent& event) {
  switch (on.hand.drag) {
    case Drag::kCut:
      if (event.button == GLFW_MOUSE_BUTTON_LEFT) cancel_stroke(on.hand, on.work.document);
      return;
    case Drag::kPick:
      pick_piece(on, event.mods);
      break;
    case Drag::kBox:
      choose_in_box(on, event.mods);
      break;
    case Drag::kMeasure:
      measure_point(on);
      break;
    case Drag::kPiece:
      if (on.hand.move) confirm_move(on.hand, on.view, on.requests);
      break;
    case Drag::kPath:
      on.lasers.path_tool.release();
      break;
    case Drag::kSection:
      on.hand.section.reset();
      break;
    case Drag::kPull:
      on.hand.spring.reset();
      break;
    case Drag::kAxes:
      if (const auto axis = axis_end_under(on.view, on.hand.pointer))
        on.view.camera.turn_to(axis->view.yaw, axis->view.pitch);
      break;
    default:
      break;
  }
  on.hand.drag = Drag::kNone;
}

}  // namespace

void handle_mouse(const MouseParts& on, const InputEvent& event, bool free) {
  const Vec2 from = on.hand.pointer;
  on.hand.pointer = event.at;
  on.hand.over_picture = free && on.view.layout.viewport.contains(event.at);
  if (on.hand.drag == Drag::kNone) on.view.in_second = on.view.layout.second.contains(event.at);
  switch (event.kind) {
    case InputEvent::Kind::kPress:
      if (on.hand.drag == Drag::kNone && on.hand.over_picture)
        begin(on, drag_of(on.hand.tool, event.button, event.mods), event);
      break;
    case InputEvent::Kind::kMove:
      go_on(on, from, event.seconds);
      break;
    case InputEvent::Kind::kRelease:
      end(on, event);
      break;
    case InputEvent::Kind::kWheel:
      if (on.hand.over_picture && on.hand.drag != Drag::kCut) {
        const Vec2 p = on.view.in_picture(event.at);
        on.view.camera.zoom(std::pow(kZoomPerNotch, event.wheel * on.settings.wheel_speed), p.x, p.y,
                            on.view.aspect());
      }
      break;
    case InputEvent::Kind::kKey:
      break;
  }
}

}  // namespace kerf
