#include "ui/editor/pieces/piece_move.h"

#include <GLFW/glfw3.h>
#include <array>
#include <cmath>
#include <cstdlib>

#include "core/base/assert.h"
#include "core/base/deterministic_math.h"
#include "core/document/edit_piece.h"
#include "ui/editor/shared/gizmo.h"
#include "ui/editor/shared/piece_set.h"
#include "ui/editor/shared/viewport.h"
#include "ui/render/bodies/pick.h"
#include "ui/render/view/view_options.h"
#include "ui/window/number_text.h"

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
  const FirstPicture picture(view);
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
constexpr size_t kMaxTyped = 18;

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
    if (typed.size() < kMaxTyped) typed += *digit;
  } else {
    return false;
  }
  return true;
}

std::optional<PieceMove::Axis> axis_of(int key) {
  if (key < GLFW_KEY_X || key > GLFW_KEY_Z) return std::nullopt;
  return static_cast<PieceMove::Axis>(key - GLFW_KEY_X);
}

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
    : kind_(kind), piece_(piece), from_(from), pivot_(pivot), view_(view), began_(pointer), now_(pointer) {}

void PieceMove::go_on_from(const CameraView& view, Vec2 pointer) {
  carried_ = pointed_shift();
  view_ = view;
  began_ = now_ = pointer;
}

void PieceMove::point(const CameraView& view, Vec2 pointer) {
  if (!(view == view_)) return go_on_from(view, pointer);
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

// Without an axis, returns the direction to the eye, so that the piece turns with the pointer on the screen.
Vec3 PieceMove::turning_axis() const { return axis_ ? direction_of(*axis_) : -view_.forward; }

double PieceMove::angle() const {
  if (const auto amount = typed_amount()) return *amount * kDegree;
  const double turned = glm::dot(turning_axis(), view_.forward) > 0 ? -turned_ : turned_;
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
  if (!typed_.empty()) return text + typed_ + (moves ? std::string(" ") + unit : " degrees");
  constexpr double kHalfTurn = 180;
  if (!moves) return text + number_text(angle() / kDegree, "%.4g", kHalfTurn) + " degrees";
  const Vec3 by = shift();
  const auto shown = [&](double way) { return number_text(way, "%.4g", glm::length(by)); };
  const std::string end = std::string(" ") + unit + (snap_ && snap_->vertex ? ", to a vertex" : "");
  if (axis_) return text + shown(by[static_cast<int>(*axis_)]) + end;
  return text + shown(by.x) + ", " + shown(by.y) + ", " + shown(by.z) + end;
}

namespace {

void show_at(ViewState& view, const PieceId& piece, const PieceMove::Look& at) {
  PieceLook& look = view.look.pieces[piece];
  look.turn = at.turn;
  look.offset = at.offset;
  view.picture_old = true;
}

}  // namespace

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
  if (view_.spread != 0) {
    view_.spread = 0;
    spread_pieces(world, 0, view_.look);
  }
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
  if (move_ && !has_faces(world, move_->piece())) end();
}

}  // namespace kerf
