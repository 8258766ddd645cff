#include "ui/editor/pieces/piece_placement.h"

#include <GLFW/glfw3.h>
#include <imgui.h>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <utility>

#include "core/base/assert.h"
#include "core/base/deterministic_math.h"
#include "core/document/extract.h"
#include "ui/editor/shared/feature.h"
#include "ui/editor/shared/file_frames.h"
#include "ui/editor/shared/panel_rows.h"
#include "ui/editor/shared/piece_set.h"
#include "ui/editor/shared/viewport_pointer.h"
#include "ui/render/bodies/body_picture.h"
#include "ui/render/view/view_options.h"
#include "ui/window/theme.h"
#include "ui/window/widgets.h"

namespace kerf {

double snap_step(FileUnit unit) {
  switch (unit) {
    case FileUnit::kMillimetre:
    case FileUnit::kCentimetre:
      return 1;
    case FileUnit::kMetre:
      return 0.01;
    case FileUnit::kInch:
      return 0.1;
  }
  return 0.01;
}

std::optional<Vec3> vertex_near(const World& world, const ViewState& view, Vec2 pointer,
                                const PieceId& moved) {
  const PrimaryViewport picture(view);
  ViewOptions others = view.look;
  others.pieces[moved].hidden = true;
  const std::optional<Pick> seen = pick(world, others, picture.ray(pointer));
  if (!seen) return std::nullopt;
  const Body& body = world.body(seen->body);
  std::optional<Vec3> nearest;
  double least = picture.em();
  for (const Vec3& corner : body.mesh.triangle(seen->face)) {
    const Vec3 at = body.placement.to_world(corner);
    const std::optional<Vec2> place = picture.place_of(at);
    if (!place || glm::length(*place - pointer) > least) continue;
    least = glm::length(*place - pointer);
    nearest = at;
  }
  return nearest;
}

namespace {

constexpr double kTurn = 2 * kPi, kDegree = kTurn / 360;

constexpr size_t kMaxTypedDigits = 18;

// Intersects a ray with the plane through `at` parallel to the screen.
Vec3 on_picture_plane(const CameraView& view, const Pose& ray, const Vec3& at) {
  const double depth = glm::dot(at - ray.origin, view.forward);
  return ray.origin + ray.direction * (depth / glm::dot(ray.direction, view.forward));
}

// Returns the direction from the pivot to the pointer on the screen, in radians, counterclockwise.
double direction_in_picture(const CameraView& view, const Vec3& pivot, Vec2 pointer) {
  const Vec3 seen = view.project(pivot);
  const Vec2 way = (pointer - Vec2(seen)) * Vec2(view.aspect, 1);
  return std::atan2(way.y, way.x);
}

// Returns the digit of a key above the letters or on the number pad.
std::optional<char> digit_of(int key) {
  if (key >= GLFW_KEY_0 && key <= GLFW_KEY_9) return static_cast<char>('0' + key - GLFW_KEY_0);
  if (key >= GLFW_KEY_KP_0 && key <= GLFW_KEY_KP_9) return static_cast<char>('0' + key - GLFW_KEY_KP_0);
  return std::nullopt;
}

// Edits a typed amount. Minus toggles the sign at any position.
bool edit_amount(std::string& typed, int key) {
  const bool minus = key == GLFW_KEY_MINUS || key == GLFW_KEY_KP_SUBTRACT;
  const bool point = key == GLFW_KEY_PERIOD || key == GLFW_KEY_COMMA || key == GLFW_KEY_KP_DECIMAL;
  const auto digit = digit_of(key);
  if (minus) {
    typed = typed.starts_with('-') ? typed.substr(1) : "-" + typed;
  } else if (key == GLFW_KEY_BACKSPACE) {
    if (!typed.empty()) typed.pop_back();
  } else if (point) {
    if (typed.find('.') == std::string::npos) typed += '.';
  } else if (digit) {
    if (typed.size() < kMaxTypedDigits) typed += *digit;
  } else {
    return false;
  }
  return true;
}

std::optional<PieceMove::Axis> axis_of(int key) {
  if (key < GLFW_KEY_X || key > GLFW_KEY_Z) return std::nullopt;
  return static_cast<PieceMove::Axis>(key - GLFW_KEY_X);
}

void show_at(ViewState& view, const PieceId& piece, const PieceMove::Look& at) {
  PieceLook& look = view.look.pieces[piece];
  look.turn = at.turn;
  look.offset = at.offset;
  view.picture_old = true;
}

constexpr double kRadiansOfDegree = kPi / 180;
constexpr double kHalfTurn = 180;  // degrees

// Removes rounding errors of sines and cosines, and the sign of zero.
double tidy(double degrees) { return std::round(degrees * 1e9) / 1e9 + 0.0; }

}  // namespace

Vec3 direction_of(PieceMove::Axis axis) {
  Vec3 direction(0);
  direction[static_cast<int>(axis)] = 1;
  return direction;
}

Vec3 pivot_of(const Body& body, uint32_t label) {
  KERF_ASSERT(label < body.pieces.size());
  const Piece& piece = body.pieces[label];
  const Vec3 centre = piece.area > 0 ? piece.moments.first / piece.area : Vec3(0);
  return body.placement.to_world(body.middle() + centre);
}

PieceMove::PieceMove(Kind kind, const PieceId& piece, const Placement& from, const Vec3& pivot,
                     const CameraView& view, Vec2 pointer)
    : kind_(kind),
      piece_(piece),
      from_(from),
      pivot_(pivot),
      facing_(-view.forward),
      view_(view),
      began_(pointer),
      now_(pointer) {}

void PieceMove::resume_from(const CameraView& view, Vec2 pointer) {
  carried_ = pointed_shift();
  const bool was_behind = sees_axis_from_behind();
  view_ = view;
  began_ = now_ = pointer;
  if (sees_axis_from_behind() != was_behind) turned_ = -turned_;
}

void PieceMove::point(const CameraView& view, Vec2 pointer) {
  if (!(view == view_)) return resume_from(view, pointer);
  const double before = direction_in_picture(view_, pivot_, now_);
  turned_ += std::remainder(direction_in_picture(view, pivot_, pointer) - before, kTurn);
  now_ = pointer;
}

bool PieceMove::key(int key) {
  if (const auto axis = axis_of(key)) {
    axis_ = axis_ == axis ? std::nullopt : axis;
    return true;
  }
  return edit_amount(typed_, key);
}

std::optional<double> PieceMove::typed_amount() const {
  if (typed_.find_first_of("0123456789") == std::string::npos) return std::nullopt;
  return std::strtod(typed_.c_str(), nullptr);
}

Vec3 PieceMove::pointed_shift() const {
  const Pose from = view_.ray(began_.x, began_.y), to = view_.ray(now_.x, now_.y);
  const Vec3 at = pivot_ + carried_;
  if (!axis_) return carried_ + on_picture_plane(view_, to, at) - on_picture_plane(view_, from, at);
  const Vec3 axis = direction_of(*axis_);
  return axis * (glm::dot(carried_, axis) + dragged_along(from, to, at, axis));
}

Vec3 PieceMove::shift() const {
  if (const auto amount = typed_amount()) return direction_of(axis_.value_or(Axis::kX)) * *amount;
  return snap_ ? snapped_shift() : pointed_shift();
}

// Moves the pivot to the vertex, or by whole steps along each free axis.
Vec3 PieceMove::snapped_shift() const {
  const auto along = [&](const Vec3& way) {
    if (!axis_) return way;
    const Vec3 axis = direction_of(*axis_);
    return axis * glm::dot(way, axis);
  };
  if (snap_->vertex) return along(*snap_->vertex - pivot_);
  return along(glm::round(pointed_shift() / snap_->step) * snap_->step);
}

// Without an axis, returns the direction to the eye at the beginning, so that the piece turns with the
// pointer on the screen, and stays in place when the view changes.
Vec3 PieceMove::turning_axis() const { return axis_ ? direction_of(*axis_) : facing_; }

bool PieceMove::sees_axis_from_behind() const { return glm::dot(turning_axis(), view_.forward) > 0; }

double PieceMove::angle() const {
  if (const auto amount = typed_amount()) return *amount * kDegree;
  const double turned = sees_axis_from_behind() ? -turned_ : turned_;
  constexpr double kStep = MoveSnap::kDegrees * kDegree;
  return snap_ ? std::round(turned / kStep) * kStep : turned;
}

PieceMove::Look PieceMove::look() const {
  if (kind_ == Kind::kMove) return {{1, 0, 0, 0}, shift()};
  const double radians = angle();
  if (radians == 0) return {{1, 0, 0, 0}, Vec3(0)};
  const glm::dquat turn = glm::angleAxis(radians, turning_axis());
  return {turn, pivot_ - turn * pivot_};
}

Placement PieceMove::placement() const {
  const Look look = this->look();
  if (kind_ == Kind::kMove) return {from_.position + look.offset, from_.orientation};
  if (look.turn == glm::dquat(1, 0, 0, 0)) return from_;
  return {pivot_ + look.turn * (from_.position - pivot_), glm::normalize(look.turn * from_.orientation)};
}

std::string PieceMove::words(const char* unit) const {
  constexpr std::array kNames{" X", " Y", " Z"};
  const std::string axis = axis_ ? kNames[static_cast<size_t>(*axis_)] : "";
  const bool moves = kind_ == Kind::kMove;
  std::string text = (moves ? "Move" : "Rotate");
  if (!axis.empty()) text += (moves ? " along" : " about") + axis;
  text += ": ";
  if (!typed_.empty()) return text + typed_ + (moves ? std::string(" ") + unit : "\u00b0");
  constexpr double kHalfTurn = 180;
  if (!moves) return text + number_text(angle() / kDegree, "%.4g", kHalfTurn) + "\u00b0";
  const Vec3 by = shift();
  const auto shown = [&](double way) { return number_text(way, "%.4g", glm::length(by)); };
  const std::string end = std::string(" ") + unit + (snap_ && snap_->vertex ? ", to a vertex" : "");
  if (axis_) return text + shown(by[static_cast<int>(*axis_)]) + end;
  return text + shown(by.x) + ", " + shown(by.y) + ", " + shown(by.z) + end;
}

const char* move_disabled_reason(const PieceMap& looks) {
  if (const char* why = no_selection_reason(looks)) return why;
  return selected_count(looks) > 1 ? "Select a single piece to move it." : nullptr;
}

const PieceMove& Moving::move() const {
  KERF_ASSERT(move_);
  return *move_;
}

void Moving::begin(const World& world, PieceMove::Kind kind, Vec2 pointer) {
  KERF_ASSERT(move_disabled_reason(view_.look.pieces) == nullptr);
  const PieceId piece = *first_selected(view_.look.pieces);
  end_exploded_view(world, view_);
  const Body& body = world.body(piece.body);
  move_.emplace(kind, piece, body.placement, pivot_of(body, piece.label), view_.seen_first(),
                view_.in_first(pointer));
}

bool Moving::key(int key) {
  KERF_ASSERT(move_);
  return move_->key(key);
}

void Moving::constrain(PieceMove::Axis axis) {
  KERF_ASSERT(move_);
  move_->constrain(axis);
}

void Moving::follow(const World& world, Vec2 pointer, bool snaps) {
  KERF_ASSERT(move_);
  std::optional<MoveSnap> snap;
  if (snaps) snap = MoveSnap{snap_step(view_.frame.unit), std::nullopt};
  if (snaps && move_->kind() == PieceMove::Kind::kMove)
    snap->vertex = vertex_near(world, view_, pointer, move_->piece());
  move_->snap(snap);
  move_->point(view_.seen_first(), view_.in_first(pointer));
  show_at(view_, move_->piece(), move_->look());
}

void Moving::end() {
  show_at(view_, move().piece(), {{1, 0, 0, 0}, Vec3(0)});
  drop_plain(view_.look.pieces);
  move_.reset();
}

std::optional<Command> Moving::confirm() {
  std::optional<Command> command;
  if (move().moves()) command = MovePiece{move_->piece(), move_->placement()};
  end();
  return command;
}

void Moving::drop_if_lost(const World& world) {
  const PieceMap& looks = view_.look.pieces;
  if (move_ && (!has_faces(world, move_->piece()) || move_disabled_reason(looks) != nullptr ||
                first_selected(looks) != move_->piece()))
    end();
}

namespace {

constexpr double kArrowEms = 5.5, kRingEms = 4.2;  // length and radius
constexpr double kFreeFromEms = 1.2;  // radius around the pivot without handles: a click there selects

constexpr std::array kAxes{PieceMove::Axis::kX, PieceMove::Axis::kY, PieceMove::Axis::kZ};

char letter_of(PieceMove::Axis axis) { return static_cast<char>('X' + static_cast<int>(axis)); }

PieceHandle arrow(const PrimaryViewport& picture, const Vec3& pivot, PieceMove::Axis axis) {
  PieceHandle handle{{picture, std::string("move ") + letter_of(axis),
                      gizmo_arrow(picture, pivot, direction_of(axis), kArrowEms), 1},
                     PieceMove::Kind::kMove,
                     axis};
  handle.free_share = kFreeFromEms / kArrowEms;
  return handle;
}

PieceHandle ring(const PrimaryViewport& picture, const Vec3& pivot, PieceMove::Axis axis) {
  const auto i = static_cast<size_t>(axis);
  const Vec3 u = direction_of(kAxes.at((i + 1) % 3)), v = direction_of(kAxes.at((i + 2) % 3));
  return {{picture, std::string("turn ") + letter_of(axis), gizmo_ring(picture, pivot, u, v, kRingEms),
           kGizmoRing / 2},
          PieceMove::Kind::kTurn,
          axis};
}

// Draws a long line through the pivot along the axis of the move.
void draw_axis(const PrimaryViewport& picture, const Vec3& pivot, PieceMove::Axis axis, ImDrawList& list) {
  const Vec3 way = direction_of(axis) * (60 * picture.metres_of_em(pivot));
  Vec3 ends[2] = {pivot - way, pivot + way};
  for (Vec3& end : ends) {
    for (int i = 0; i < 8 && !picture.place_of(end); ++i) end = 0.5 * (end + pivot);
  }
  const auto from = picture.place_of(ends[0]), to = picture.place_of(ends[1]);
  if (from && to) list.AddLine(to_im(*from), to_im(*to), colours::kAxes.at(static_cast<size_t>(axis)), 1.5f);
}

void draw_words(const Area& picture, const std::string& words, ImDrawList& list) {
  constexpr const char* kKeys =
      "X/Y/Z lock axis   type amount   Enter/click confirm   Esc/right-click cancel";
  const float em = ImGui::GetFontSize(), line = ImGui::GetTextLineHeight();
  const float width = std::max(ImGui::CalcTextSize(words.c_str()).x, ImGui::CalcTextSize(kKeys).x);
  const auto x = static_cast<float>(picture.at.x + 0.5 * picture.size.x) - 0.5f * width;
  const auto y = static_cast<float>(picture.at.y + picture.size.y) - 4 * em;
  list.AddRectFilled({x - em, y - 0.6f * em}, {x + width + em, y + 2.2f * line + 0.6f * em},
                     IM_COL32(0x1b, 0x1f, 0x26, 225), 3);
  list.AddText({x, y}, colours::kPictureText, words.c_str());
  list.AddText({x, y + 1.2f * line}, colours::kPictureSecondary, kKeys);
}

// Like pivot_shown(), but also behind the eye.
std::optional<Vec3> rotated_about(const PieceMap& looks, const std::optional<PieceMove>& move, bool picks,
                                  const World& world) {
  if (move) {
    const PieceMove::Look look = move->look();
    return look.turn * move->pivot() + look.offset;
  }
  if (!picks || move_disabled_reason(looks) != nullptr) return std::nullopt;
  const PieceId piece = *first_selected(looks);
  const PieceLook& look = looks.at(piece);
  return look.turn * pivot_of(world.body(piece.body), piece.label) + look.offset;
}

}  // namespace

std::optional<Vec3> pivot_shown(const ViewState& view, const std::optional<PieceMove>& move, bool picks,
                                const World& world) {
  const auto pivot = rotated_about(view.look.pieces, move, picks, world);
  return pivot && PrimaryViewport(view).place_of(*pivot) ? pivot : std::nullopt;
}

std::vector<PieceHandle> piece_handles(const ViewState& view, const std::optional<Vec3>& pivot) {
  std::vector<PieceHandle> handles;
  if (!pivot) return handles;
  const PrimaryViewport picture(view);
  for (const PieceMove::Axis axis : kAxes) handles.push_back(ring(picture, *pivot, axis));
  for (const PieceMove::Axis axis : kAxes) handles.push_back(arrow(picture, *pivot, axis));
  return handles;
}

void draw_piece_handles(const ViewState& view, const std::optional<Vec3>& pivot,
                        const std::optional<PieceMove>& move, Vec2 pointer, ImDrawList& list) {
  if (!pivot) return;
  if (move) {
    if (move->axis()) draw_axis(PrimaryViewport(view), *pivot, *move->axis(), list);
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

Vec3 angles_of(const glm::dquat& orientation) {
  const glm::dquat& q = orientation;
  // The turned X axis is (along, across, -sine).
  const double along = q.w * q.w + q.x * q.x - q.y * q.y - q.z * q.z, across = 2 * (q.x * q.y + q.w * q.z);
  const double sine = 2 * (q.w * q.y - q.x * q.z), cosine = std::hypot(along, across);
  Vec3 radians(glm::pitch(q), std::atan2(sine, cosine), std::atan2(across, along));
  // Rounding determines the direction of a shorter projection.
  const double least_cosine = std::sqrt(std::numeric_limits<double>::epsilon());
  if (cosine < least_cosine) {
    radians.x = std::remainder(2 * std::atan2(q.x, q.w), kTurn);
    radians.z = 0;
  }
  return {tidy(radians.x / kRadiansOfDegree), tidy(radians.y / kRadiansOfDegree),
          tidy(radians.z / kRadiansOfDegree)};
}

glm::dquat orientation_of(const Vec3& angles) {
  return glm::normalize(glm::dquat(angles * kRadiansOfDegree));
}

// A press in the viewport selects another piece before a field that it leaves has reported its entry, which
// belongs to the piece before.
std::optional<Command> PlacementRows::draw(const World& world, const ViewState& view) {
  if (!begin_properties("placement")) return std::nullopt;
  const char* disabled_reason = move_disabled_reason(view.look.pieces);
  if (!fields_.is_active() || !edited_ || !has_faces(world, *edited_))
    edited_ = disabled_reason == nullptr ? first_selected(view.look.pieces) : std::nullopt;
  std::optional<Command> command;
  if (edited_) {
    command = draw_fields(world, view, *edited_);
  } else {
    draw_empty(disabled_reason);
  }
  end_properties();
  return command;
}

std::optional<Command> PlacementRows::draw_fields(const World& world, const ViewState& view,
                                                  const PieceId& piece) {
  const Body& body = world.body(piece.body);
  Placement to = body.placement;
  const Vec3 before = pivot_of(body, piece.label), centre_in_body = to.to_body(before);
  Vec3 centre = before, angles = angles_of(to.orientation);
  if (fields_.vector("Centre", centre, "%.5g",
                     "Centre of area of the selected piece, in the unit of the file.",
                     file_unit(view.frame.unit), world.loaded_bounds().diagonal()))
    to.position += centre - before;
  if (fields_.vector("Rotation", angles, "%.4g",
                     "Rotation about X, then Y, then Z, about the centre; 0: as loaded.", kDegrees,
                     kHalfTurn)) {
    to.orientation = orientation_of(angles);
    to.position = before - to.orientation * centre_in_body;
  }
  return to != body.placement ? std::optional<Command>(MovePiece{piece, to}) : std::nullopt;
}

void PlacementRows::draw_empty(const char* why) {
  ImGui::BeginDisabled();
  for (const char* name : {"Centre", "Rotation"}) {
    property(name);
    std::array<char, 2> text{"-"};
    ImGui::InputText((std::string("##") + name).c_str(), text.data(), text.size(),
                     ImGuiInputTextFlags_ReadOnly);
    tooltip(why);
  }
  ImGui::EndDisabled();
}

namespace {

class TransformFeature : public Feature {
 public:
  explicit TransformFeature(Workspace& workspace) : workspace_(workspace) {
    workspace.links.time_holds.push_back(
        [this] { return moving_.moves() ? "Bodies do not move while you place a piece." : nullptr; });
  }

  std::vector<PanelPart> panel_parts() override {
    return {{"pieces.placement", [this] { draw_placement(); }}};
  }
  std::vector<UserAction> actions() override {
    return {move_action("pieces.move", "Move", "G", PieceMove::Kind::kMove),
            move_action("pieces.rotate", "Rotate", "R", PieceMove::Kind::kTurn), duplicate_action()};
  }
  std::vector<Gesture> gestures() const override {
    return {{"move_piece", "Left drag on an arrow or a ring",
             "Move or rotate the selected piece with the Select tool; Ctrl snaps to steps and vertices"}};
  }
  // A piece moved by keys follows the pointer without a button; a click confirms. A press of the right button
  // cancels, also during a drag.
  bool handle_event(const InputEvent& event, bool in_picture) override {
    if (!moving_.moves()) return false;
    if (event.kind == InputEvent::Kind::kKey) {
      // A held key must not flip the axis or begin the move again.
      if (!event.again || event.button == GLFW_KEY_BACKSPACE) take_key(event.button, is_snapping(event));
      return true;
    }
    const bool left = event.button == GLFW_MOUSE_BUTTON_LEFT, right = event.button == GLFW_MOUSE_BUTTON_RIGHT;
    const bool presses = event.kind == InputEvent::Kind::kPress && (left || right);
    if (workspace_.input.held) {
      if (presses && right) cancel_move();
      return presses && right;
    }
    if (event.kind == InputEvent::Kind::kMove) follow_pointer(event);
    if (!presses) return false;
    if (left && in_picture) {
      confirm();
    } else {
      cancel_move();
    }
    return in_picture;
  }
  std::unique_ptr<Interaction> begin_interaction(const Press& press) override {
    if (!picks(workspace_.input, press)) return nullptr;
    const auto handle = handle_under(piece_handles(workspace_.view, pivot()), workspace_.input.pointer);
    if (!handle) return nullptr;
    moving_.begin(workspace_.world(), handle->kind, workspace_.input.pointer);
    moving_.constrain(handle->axis);
    moves_copy_ = false;
    return std::make_unique<DragOfPiece>(*this);
  }
  const char* status_hint() const override {
    if (!moving_.moves()) return nullptr;
    return moving_.move().kind() == PieceMove::Kind::kMove ? "Moving a piece" : "Rotating a piece";
  }

  void update(double) override {
    moving_.drop_if_lost(workspace_.world());
    if (!workspace_.changes.is_pending()) grab_copy();
  }
  void on_document_opened() override {
    moving_.forget();
    placement_ = PlacementRows();
  }

  void draw_overlay(ImDrawList& list) override {
    if (workspace_.cutting()) return;
    draw_piece_handles(workspace_.view, pivot(), moving_.now(), workspace_.input.pointer_in_viewport(), list);
    const std::optional<MoveSnap> snap = moving_.moves() ? moving_.move().snap() : std::nullopt;
    if (snap && snap->vertex) draw_measured_point(workspace_.view, *snap->vertex, list);
  }
  void add_landmarks(Landmarks& landmarks) const override {
    mark_handles(piece_handles(workspace_.view, pivot()), landmarks);
  }

 private:
  class DragOfPiece : public Interaction {
   public:
    explicit DragOfPiece(TransformFeature& feature) : feature_(feature) {}
    void move(const InputEvent& event) override {
      if (!over()) feature_.follow_pointer(event);
    }
    void release(const InputEvent&) override {
      if (!over()) feature_.confirm();
    }
    bool over() const override { return !feature_.moving_.moves(); }

   private:
    TransformFeature& feature_;
  };

  std::optional<Vec3> pivot() const {
    return pivot_shown(workspace_.view, moving_.now(), workspace_.input.picks(), workspace_.world());
  }
  // The key moves the piece only if the Select tool is active and a piece is selected.
  UserAction move_action(const char* id, const char* name, const char* key, PieceMove::Kind kind) {
    return make_action(
        id, name, key,
        "The selected piece follows the pointer: X/Y/Z lock an axis, digits set the amount. The key needs "
        "the Select tool.",
        [this, kind] {
          cancel_stroke(workspace_);
          moving_.begin(workspace_.world(), kind, workspace_.input.pointer);
          moves_copy_ = false;
        },
        {.disabled_reason = [this] { return move_disabled_reason(workspace_.view.look.pieces); },
         .has_key_when =
             [this] { return workspace_.input.picks() && selected_count(workspace_.view.look.pieces) > 0; }});
  }
  UserAction duplicate_action() {
    return {.id = "pieces.duplicate",
            .name = "Duplicate",
            .shortcut = "Ctrl+D",
            .also = {GLFW_KEY_D, GLFW_MOD_SHIFT},
            .tip = "Adds a copy of the selected piece and moves it with the pointer.",
            .run = [this] { workspace_.changes.enqueue("Duplicate", [this] { duplicate(); }); },
            .disabled_reason = [this] { return move_disabled_reason(workspace_.view.look.pieces); }};
  }
  void draw_placement() {
    if (const auto command = placement_.draw(workspace_.world(), workspace_.view))
      workspace_.changes.enqueue(*command);
  }

  static bool is_snapping(const InputEvent& event) { return (event.mods & GLFW_MOD_CONTROL) != 0; }
  void follow_pointer(const InputEvent& event) {
    moving_.follow(workspace_.world(), event.at, is_snapping(event));
  }
  // Enter confirms, Esc cancels, G and R switch between moving and turning; PieceMove::key handles the rest.
  void take_key(int key, bool snaps) {
    switch (key) {
      case GLFW_KEY_ENTER:
      case GLFW_KEY_KP_ENTER:
        return confirm();
      case GLFW_KEY_ESCAPE:
        return cancel_move();
      case GLFW_KEY_G:
      case GLFW_KEY_R:
        moving_.begin(workspace_.world(), key == GLFW_KEY_G ? PieceMove::Kind::kMove : PieceMove::Kind::kTurn,
                      workspace_.input.pointer);
        break;
      default:
        if (!moving_.key(key)) return;
        break;
    }
    moving_.follow(workspace_.world(), workspace_.input.pointer, snaps);
  }
  void confirm() {
    if (const auto command = moving_.confirm()) workspace_.changes.enqueue(*command);
  }
  // Cancelling the move of a copy undoes the copy, and time that has passed since.
  void cancel_move() {
    if (moves_copy_) workspace_.changes.enqueue("Undo", [this] { undo_copy(); });
    moving_.end();
  }
  void undo_copy() {
    cancel_stroke(workspace_);
    const UndoStack& history = workspace_.session.document.history();
    if (history.position() <= before_copy_) return;
    const std::string did = "Undo: " + step_words(history, before_copy_, workspace_.view.frame.unit);
    workspace_.changes.travel_to(before_copy_, did, did);
  }
  // The piece may have been hidden, and so deselected, since the request.
  void duplicate() {
    const auto piece = first_selected(workspace_.view.look.pieces);
    if (!piece) return;
    newest_before_copy_ = workspace_.world().ids().back();
    before_copy_ = workspace_.session.document.history().position();
    workspace_.changes.apply(DuplicatePiece{*piece, workspace_.world().body(piece->body).placement});
  }
  // Selects the requested copy, if it exists, and begins to move it.
  void grab_copy() {
    const std::optional<BodyId> newest_before = std::exchange(newest_before_copy_, std::nullopt);
    const std::vector<BodyId> ids = workspace_.world().ids();
    if (!newest_before || ids.empty() || ids.back() == *newest_before) return;
    const Records<Piece>& pieces = workspace_.world().body(ids.back()).pieces;
    deselect_all(workspace_.view.look.pieces);
    for (uint32_t label = 0; label < pieces.size(); ++label) {
      if (pieces[label].faces > 0) workspace_.view.look.pieces[{ids.back(), label}].selected = true;
    }
    moving_.begin(workspace_.world(), PieceMove::Kind::kMove, workspace_.input.pointer);
    moves_copy_ = true;
    workspace_.view.picture_old = true;
  }

  Workspace& workspace_;
  Moving moving_{workspace_.view};
  bool moves_copy_ = false;                   // the piece is a copy made for the move
  std::optional<BodyId> newest_before_copy_;  // newest body when the copy was requested
  size_t before_copy_ = 0;                    // position of the history, likewise
  PlacementRows placement_;
};

}  // namespace

std::unique_ptr<Feature> transform_feature(Workspace& workspace) {
  return std::make_unique<TransformFeature>(workspace);
}

}  // namespace kerf
