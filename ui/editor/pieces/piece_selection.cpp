#include "ui/editor/pieces/piece_selection.h"

#include <GLFW/glfw3.h>
#include <imgui.h>
#include <algorithm>
#include <array>
#include <optional>

#include "ui/editor/shared/piece_set.h"
#include "ui/editor/shared/user_input.h"
#include "ui/editor/shared/viewport_pointer.h"
#include "ui/editor/shared/world_changes.h"
#include "ui/render/bodies/piece_looks.h"
#include "ui/window/theme.h"
#include "ui/window/widgets.h"

namespace kerf {

namespace {

constexpr double kDash = 6, kGap = 4;  // screen coordinates

using Corners = std::array<Vec2, 3>;

bool contains(const RubberBand& band, const Corners& corners) {
  const Vec2 low = band.low(), high = band.high();
  return std::all_of(corners.begin(), corners.end(), [&](const Vec2& c) {
    return low.x <= c.x && c.x <= high.x && low.y <= c.y && c.y <= high.y;
  });
}

// Returns true if the triangle intersects the box. Method: separating axes; the sides of both suffice for
// convex polygons.
bool touches(const RubberBand& band, const Corners& corners) {
  const Vec2 low = band.low(), high = band.high();
  const Vec2 least = glm::min(corners[0], glm::min(corners[1], corners[2]));
  const Vec2 most = glm::max(corners[0], glm::max(corners[1], corners[2]));
  if (least.x > high.x || least.y > high.y || most.x < low.x || most.y < low.y) return false;
  for (size_t i = 0; i < 3; ++i) {
    const Vec2 side = corners[(i + 1) % 3] - corners[i], normal(-side.y, side.x);
    const double third = glm::dot(corners[(i + 2) % 3] - corners[i], normal);
    const double sign = third < 0 ? -1 : 1;
    double innermost = -1;
    for (int c = 0; c < 4; ++c) {
      const Vec2 corner(c & 1 ? high.x : low.x, c & 2 ? high.y : low.y);
      innermost = std::max(innermost, sign * glm::dot(corner - corners[i], normal));
      if (innermost >= 0) break;
    }
    if (innermost < 0) return false;
  }
  return true;
}

// Tests the pieces of one body, and visits no more faces of a piece than needed.
class PiecesOfBody {
 public:
  PiecesOfBody(BodyId id, const Body& body, const ViewOptions& options)
      : body_(body), looks_(id, options), decided_(body.pieces.size()), selected_(body.pieces.size()) {
    for (uint32_t label = 0; label < body.pieces.size(); ++label) decided_[label] = looks_.of(label).hidden;
  }

  void look(const RubberBand& band, const CameraView& view) {
    const bool touching = band.touching();
    for (uint32_t f = 0; f < body_.mesh.face_slots(); ++f) {
      if (!body_.mesh.is_live(FaceId(f))) continue;
      const uint32_t label = body_.mesh.data(FaceId(f)).piece;
      if (decided_[label]) continue;
      const std::optional<Corners> seen =
          corners_of(FaceId(f), looks_.of(body_.mesh, FaceId(f)).offset, view);
      if (!touching) selected_[label] = true;
      const bool in = seen && (touching ? touches(band, *seen) : contains(band, *seen));
      if (in != touching) continue;
      decided_[label] = true;
      selected_[label] = touching;
    }
  }
  bool selected(uint32_t label) const { return selected_[label]; }

 private:
  // Returns nullopt if a corner lies behind the eye.
  std::optional<Corners> corners_of(FaceId face, const Vec3& offset, const CameraView& view) const {
    const Triangle t = body_.mesh.triangle(face);
    Corners corners;
    for (size_t i = 0; i < 3; ++i) {
      const Vec3 seen = view.project(body_.placement.to_world(t[i]) + offset);
      if (!(seen.z > 0)) return std::nullopt;
      corners[i] = Vec2(seen);
    }
    return corners;
  }

  const Body& body_;
  BodyLooks looks_;
  std::vector<char> decided_, selected_;  // by label
};

void draw_dashes(Vec2 from, Vec2 to, ImU32 colour, ImDrawList& list) {
  const double length = glm::length(to - from);
  for (double at = 0; at < length; at += kDash + kGap) {
    const double end = std::min(at + kDash, length);
    list.AddLine(to_im(from + (to - from) * (at / length)), to_im(from + (to - from) * (end / length)),
                 colour, 1.5f);
  }
}

}  // namespace

std::vector<PieceId> pieces_in(const RubberBand& band, const World& world, const ViewOptions& look,
                               const CameraView& view) {
  std::vector<PieceId> found;
  for (const BodyId id : world.ids()) {
    const Body& body = world.body(id);
    if (body.hidden) continue;
    PiecesOfBody pieces(id, body, look);
    pieces.look(band, view);
    for (uint32_t label = 0; label < body.pieces.size(); ++label) {
      if (pieces.selected(label)) found.push_back({id, label});
    }
  }
  return found;
}

void draw_rubber_band(const RubberBand& band, ImDrawList& list) {
  const Vec2 low = band.low(), high = band.high();
  list.AddRectFilled(to_im(low), to_im(high), (colours::accent() & ~IM_COL32_A_MASK) | IM_COL32(0, 0, 0, 26));
  if (!band.touching()) {
    list.AddRect(to_im(low), to_im(high), colours::accent(), 0, 0, 1.5f);
    return;
  }
  const std::array<Vec2, 4> corners{low, Vec2(high.x, low.y), high, Vec2(low.x, high.y)};
  for (size_t i = 0; i < 4; ++i) draw_dashes(corners[i], corners[(i + 1) % 4], colours::accent(), list);
}

namespace {

class PressOnPieces : public Interaction {
 public:
  explicit PressOnPieces(Workspace& workspace)
      : workspace_(workspace), pressed_at_(workspace.input.pointer) {}

  void move(const InputEvent&) override {
    boxes_ = boxes_ || glm::length(workspace_.input.pointer - pressed_at_) > kClickReach;
  }
  void release(const InputEvent& event) override {
    const bool add = (event.mods & GLFW_MOD_SHIFT) != 0;
    if (boxes_) {
      select_in_box(add);
    } else {
      select_under_pointer(workspace_, add);
    }
  }
  bool cancel() override { return boxes_; }
  const char* words() const override {
    return boxes_ ? "Select pieces inside the box; drag right to left for pieces it touches" : nullptr;
  }
  void draw(ImDrawList& list) const override {
    if (boxes_) draw_rubber_band({pressed_at_, workspace_.input.pointer}, list);
  }

 private:
  void select_in_box(bool add) {
    if (workspace_.view.in_second) return workspace_.message.error("Select pieces in the left half.");
    PieceMap& looks = workspace_.view.look.pieces;
    if (!add) deselect_all(looks);
    const RubberBand band{workspace_.view.in_picture(pressed_at_),
                          workspace_.view.in_picture(workspace_.input.pointer)};
    for (const PieceId& id :
         pieces_in(band, workspace_.world(), workspace_.view.look, workspace_.view.seen()))
      looks[id].selected = true;
    workspace_.view.picture_old = true;
  }

  Workspace& workspace_;
  Vec2 pressed_at_;
  bool boxes_ = false;
};

}  // namespace

std::unique_ptr<Interaction> press_on_pieces(Workspace& workspace) {
  return std::make_unique<PressOnPieces>(workspace);
}

namespace {

std::vector<BodyId> hidden_bodies(const World& world) {
  std::vector<BodyId> hidden;
  for (const BodyId id : world.ids()) {
    if (world.body(id).hidden) hidden.push_back(id);
  }
  return hidden;
}

}  // namespace

std::vector<PieceId> Isolation::to_show_again() const {
  std::vector<PieceId> pieces;
  for (const PieceId& piece : hidden_pieces(workspace_.view.look.pieces)) {
    const auto found = std::find(isolated_from_.begin(), isolated_from_.end(), piece.body);
    if (workspace_.world().contains(piece.body) && found != isolated_from_.end()) pieces.push_back(piece);
  }
  return pieces;
}

const char* Isolation::disabled_reason() const {
  if (!to_show_again().empty()) return nullptr;
  if (const char* why = no_selection_reason(workspace_.view.look.pieces)) return why;
  return other_pieces(workspace_.world(), workspace_.view.look.pieces).empty() ? "All pieces are selected."
                                                                               : nullptr;
}

void Isolation::change() {
  std::vector<PieceId> pieces = to_show_again();
  const bool hide = pieces.empty();
  if (hide) {
    pieces = other_pieces(workspace_.world(), workspace_.view.look.pieces);
    hidden_before_ = hidden_bodies(workspace_.world());
  }
  cancel_stroke(workspace_);
  workspace_.changes.change(hide ? "Isolate pieces" : "Show the other pieces",
                            is_small(workspace_.session.document),
                            edit_all(std::move(pieces), [hide](const PieceId& piece) {
                              return HidePiece{piece, hide};
                            }));
}

void Isolation::follow() {
  if (!hidden_before_) return;
  isolated_from_ = hidden_bodies(workspace_.world());
  std::erase_if(isolated_from_, [&](const BodyId& id) {
    return std::find(hidden_before_->begin(), hidden_before_->end(), id) != hidden_before_->end();
  });
  hidden_before_.reset();
}

}  // namespace kerf
