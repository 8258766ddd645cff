#include "ui/editor/pieces/area_selection.h"

#include <GLFW/glfw3.h>
#include <imgui.h>
#include <algorithm>
#include <array>
#include <limits>
#include <optional>

#include "core/base/assert.h"
#include "core/base/random.h"
#include "ui/editor/shared/viewport_pointer.h"
#include "ui/render/bodies/body_picture.h"
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
      : body_(body),
        looks_(id, body, options),
        section_(shown_section(options)),
        decided_(body.pieces.size()),
        selected_(body.pieces.size()) {
    for (uint32_t label = 0; label < body.pieces.size(); ++label) decided_[label] = looks_.of(label).hidden;
  }

  // `meets` tests the projected corners of a face. A piece is selected if one of its faces passes
  // (`touching`), or if all do.
  template <typename Test>
  void look(const CameraView& view, bool touching, const Test& meets) {
    for (uint32_t f = 0; f < body_.mesh.face_slots(); ++f) {
      if (!body_.mesh.is_live(FaceId(f))) continue;
      const uint32_t label = body_.mesh.data(FaceId(f)).piece;
      if (decided_[label]) continue;
      const Vec3& offset = looks_.of(body_.mesh, FaceId(f)).offset;
      if (is_cut_away(FaceId(f), offset)) continue;
      const std::optional<Corners> seen = corners_of(FaceId(f), offset, view);
      if (!touching) selected_[label] = true;
      const bool in = seen && meets(*seen);
      if (in != touching) continue;
      decided_[label] = true;
      selected_[label] = touching;
    }
  }
  bool selected(uint32_t label) const { return selected_[label]; }

 private:
  bool is_cut_away(FaceId face, const Vec3& offset) const {
    if (section_ == nullptr) return false;
    const Triangle t = body_.mesh.triangle(face);
    return std::ranges::all_of(t, [&](const Vec3& corner) {
      return section_->height_of(body_.placement.to_world(corner) + offset) > 0;
    });
  }
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
  const SectionPlane* section_;           // null: none
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

template <typename Test>
std::vector<PieceId> pieces_that(const World& world, const ViewOptions& look, const CameraView& view,
                                 bool touching, const Test& meets) {
  std::vector<PieceId> found;
  for (const BodyId id : world.ids()) {
    const Body& body = world.body(id);
    if (body.hidden) continue;
    PiecesOfBody pieces(id, body, look);
    pieces.look(view, touching, meets);
    for (uint32_t label = 0; label < body.pieces.size(); ++label) {
      if (pieces.selected(label)) found.push_back({id, label});
    }
  }
  return found;
}

ImU32 fill_colour() { return (colours::accent() & ~IM_COL32_A_MASK) | IM_COL32(0, 0, 0, 26); }

// Draws the box, dashed if it selects touched pieces. Corners are in the window, in screen coordinates.
void draw_rubber_band(const RubberBand& band, ImDrawList& list) {
  const Vec2 low = band.low(), high = band.high();
  list.AddRectFilled(to_im(low), to_im(high), fill_colour());
  if (!band.touching()) {
    list.AddRect(to_im(low), to_im(high), colours::accent(), 0, 0, 1.5f);
    return;
  }
  const std::array<Vec2, 4> corners{low, Vec2(high.x, low.y), high, Vec2(low.x, high.y)};
  for (size_t i = 0; i < 4; ++i) draw_dashes(corners[i], corners[(i + 1) % 4], colours::accent(), list);
}

// Draws the polyline, and the edge that closes it as dashes.
void draw_lasso(const std::vector<Vec2>& points, ImDrawList& list) {
  std::vector<ImVec2> line;
  for (const Vec2& p : points) line.push_back(to_im(p));
  const auto count = static_cast<int>(line.size());
  list.AddPolyline(line.data(), count, IM_COL32(10, 12, 16, 150), 0, 3.0f);
  list.AddPolyline(line.data(), count, colours::accent(), 0, 1.5f);
  draw_dashes(points.back(), points.front(), colours::accent(), list);
}

constexpr double kReachOfCut = 1.2;      // widths of the widest cut
constexpr double kTouchingShare = 1e-6;  // of the diagonal of the world
constexpr size_t kMaxPointsOfEdge = 64;

// The width of what a stroke removes, including faces that the rim does not cut exactly [m].
double width_of_cut(const CutSettings& settings) {
  const Resolution& resolution = settings.resolution;
  double rough = 0;
  if (resolution.rim == Rim::kFaces) {
    rough = resolution.rule == Resolution::Rule::kTargetEdge  ? resolution.target_edge
            : resolution.rule == Resolution::Rule::kTolerance ? resolution.tolerance
                                                              : settings.laser.radius;
  }
  return 2 * (settings.laser.radius + rough);
}

// Points in cubic cells, to find those near a place.
class PointGrid {
 public:
  explicit PointGrid(double cell) : cell_(cell) {}
  void add(const Vec3& point) { points_.push_back({key_of(cell_of(point)), point}); }
  // Called after all points were added.
  void sort() {
    std::sort(points_.begin(), points_.end(), [](const Entry& a, const Entry& b) { return a.key < b.key; });
  }
  // Returns true if a point lies within the size of a cell from this place.
  bool has_near(const Vec3& at) const {
    const Cell middle = cell_of(at);
    for (int i = 0; i < 27; ++i) {
      const Cell cell{middle[0] + i % 3 - 1, middle[1] + i / 3 % 3 - 1, middle[2] + i / 9 - 1};
      const auto found = std::ranges::equal_range(points_, key_of(cell), {}, &Entry::key);
      for (const Entry& entry : found) {
        if (glm::length(entry.point - at) <= cell_) return true;
      }
    }
    return false;
  }

 private:
  using Cell = std::array<int64_t, 3>;
  struct Entry {
    uint64_t key;  // of a cell; several cells may share one
    Vec3 point;
  };
  Cell cell_of(const Vec3& p) const {
    const auto along = [&](double x) { return static_cast<int64_t>(std::floor(x / cell_)); };
    return {along(p.x), along(p.y), along(p.z)};
  }
  static uint64_t key_of(const Cell& cell) {
    uint64_t key = 0;
    for (const int64_t i : cell) key = hash_combine(key, static_cast<uint64_t>(i));
    return key;
  }

  double cell_;
  std::vector<Entry> points_;
};

// Calls `use(label, point)` with points on the rims of a body in world space, at most `spacing` [m] apart.
template <typename Use>
void for_each_rim_point(const Body& body, double spacing, const Use& use) {
  std::vector<Mesh::Side> sides;
  body.mesh.append_open_sides(sides);
  for (uint32_t f = 0; body.solid && f < body.mesh.face_slots(); ++f) {
    const FaceId face(f);
    if (!body.mesh.is_live(face) || !body.walls.contain(body.mesh, face)) continue;
    const std::array<VertexId, 3> corners = body.mesh.corners(face);
    for (size_t i = 0; i < 3; ++i) sides.push_back({face, corners[i], corners[(i + 1) % 3]});
  }
  for (const Mesh::Side& side : sides) {
    const Vec3 from = body.placement.to_world(body.mesh.position(side.from));
    const Vec3 to = body.placement.to_world(body.mesh.position(side.to));
    const double wanted = std::ceil(glm::length(to - from) / spacing);
    const auto count = static_cast<size_t>(std::clamp(wanted, 1.0, static_cast<double>(kMaxPointsOfEdge)));
    for (size_t i = 0; i <= count; ++i)
      use(body.mesh.data(side.face).piece,
          from + (to - from) * (static_cast<double>(i) / static_cast<double>(count)));
  }
}

std::set<PieceId> selected_set(const PieceMap& looks) {
  const std::vector<PieceId> ids = selected_ids(looks);
  return {ids.begin(), ids.end()};
}

class PressOnPieces : public Interaction {
 public:
  PressOnPieces(Workspace& workspace, SelectionShape shape)
      : workspace_(workspace), shape_(shape), drawn_{workspace.input.pointer} {}

  void move(const InputEvent&) override {
    const Vec2 at = workspace_.input.pointer;
    drags_ = drags_ || glm::length(at - drawn_.front()) > kClickReach;
    if (glm::length(at - drawn_.back()) >= kBetweenPoints) drawn_.push_back(at);
  }
  void release(const InputEvent& event) override {
    const bool add = (event.mods & GLFW_MOD_SHIFT) != 0;
    const bool remove = (event.mods & GLFW_MOD_CONTROL) != 0 && workspace_.input.picks();
    if (drags_) {
      select_inside(add, remove);
    } else {
      select_under_pointer(workspace_, add);
    }
  }
  bool cancel() override { return drags_; }
  const char* words() const override {
    if (!drags_) return nullptr;
    if (!is_lasso()) return "Select pieces inside the box; drag right to left to include pieces it touches";
    return workspace_.input.picks() ? "Select pieces inside the lasso; Shift to add, Ctrl to remove"
                                    : "Select pieces inside the lasso; Shift to add";
  }
  void draw(ImDrawList& list) const override {
    if (!drags_) return;
    is_lasso() ? draw_lasso(drawn_, list)
               : draw_rubber_band({drawn_.front(), workspace_.input.pointer}, list);
  }

 private:
  static constexpr double kBetweenPoints = 2;  // screen coordinates

  bool is_lasso() const { return shape_ == SelectionShape::kLasso; }
  std::vector<PieceId> pieces_inside() const {
    const ViewState& view = workspace_.view;
    if (!is_lasso()) {
      const RubberBand band{view.in_picture(drawn_.front()), view.in_picture(workspace_.input.pointer)};
      return pieces_in(band, workspace_.world(), view.look, view.seen());
    }
    std::vector<Vec2> points;
    for (const Vec2& p : drawn_) points.push_back(view.in_picture(p));
    if (points.size() < 3) return {};
    return pieces_in(Lasso(std::move(points)), workspace_.world(), view.look, view.seen());
  }
  void select_inside(bool add, bool remove) {
    if (workspace_.view.in_second) return workspace_.message.error("Select pieces in the left half.");
    PieceMap& looks = workspace_.view.look.pieces;
    if (!add && !remove) deselect_all(looks);
    for (const PieceId& id : pieces_inside()) looks[id].selected = !remove;
    workspace_.view.picture_old = true;
  }

  Workspace& workspace_;
  SelectionShape shape_;
  std::vector<Vec2> drawn_;  // places of the pointer, screen coordinates; not empty
  bool drags_ = false;
};

}  // namespace

Lasso::Lasso(std::vector<Vec2> points) : points_(std::move(points)), bands_(points_.size()) {
  KERF_ASSERT(points_.size() >= 3);
  low_ = high_ = points_.front();
  for (const Vec2& p : points_) low_ = glm::min(low_, p), high_ = glm::max(high_, p);
  for (uint32_t i = 0; i < points_.size(); ++i) {
    const Vec2 &from = points_[i == 0 ? points_.size() - 1 : i - 1], &to = points_[i];
    const size_t last = band_of(std::max(from.y, to.y));
    for (size_t band = band_of(std::min(from.y, to.y)); band <= last; ++band) bands_[band].push_back(i);
  }
}

size_t Lasso::band_of(double y) const {
  const double height = high_.y - low_.y;
  if (!(height > 0)) return 0;
  const auto count = static_cast<double>(bands_.size());
  return static_cast<size_t>(std::clamp(std::floor(count * (y - low_.y) / height), 0.0, count - 1));
}

bool Lasso::contains(Vec2 p) const {
  if (p.x < low_.x || p.y < low_.y || p.x > high_.x || p.y > high_.y) return false;
  bool inside = false;
  for (const uint32_t i : bands_[band_of(p.y)]) {
    const Vec2 &from = points_[i == 0 ? points_.size() - 1 : i - 1], &to = points_[i];
    if ((from.y > p.y) == (to.y > p.y)) continue;
    if (p.x < from.x + (to.x - from.x) * (p.y - from.y) / (to.y - from.y)) inside = !inside;
  }
  return inside;
}

std::vector<PieceId> pieces_in(const RubberBand& band, const World& world, const ViewOptions& look,
                               const CameraView& view) {
  if (band.touching())
    return pieces_that(world, look, view, true, [&](const Corners& c) { return touches(band, c); });
  return pieces_that(world, look, view, false, [&](const Corners& c) { return contains(band, c); });
}

std::vector<PieceId> pieces_in(const Lasso& lasso, const World& world, const ViewOptions& look,
                               const CameraView& view) {
  return pieces_that(world, look, view, false, [&](const Corners& corners) {
    return std::all_of(corners.begin(), corners.end(), [&](const Vec2& c) { return lasso.contains(c); });
  });
}

double neighbour_reach(const Document& document) {
  const UndoStack& history = document.history();
  double width = 0;
  for (size_t step = 0; step < history.position(); ++step) {
    if (history.cuts(step)) width = std::max(width, width_of_cut(history.settings_of(step)));
  }
  const double touching = kTouchingShare * document.world().loaded_bounds().diagonal();
  return std::max({kReachOfCut * width, touching, std::numeric_limits<double>::min()});
}

std::set<PieceId> neighbours_of(const std::set<PieceId>& pieces, const World& world, double reach,
                                const PieceMap& looks) {
  KERF_ASSERT(reach > 0);
  PointGrid grid(reach);
  const auto is_hidden = [&](const PieceId& id) {
    const auto look = looks.find(id);
    return look != looks.end() && look->second.hidden;
  };
  for (const BodyId id : world.ids()) {
    for_each_rim_point(world.body(id), 0.5 * reach, [&](uint32_t label, const Vec3& point) {
      if (pieces.contains({id, label})) grid.add(point);
    });
  }
  grid.sort();
  std::set<PieceId> found;
  for (const BodyId id : world.ids()) {
    if (world.body(id).hidden) continue;
    for_each_rim_point(world.body(id), 0.5 * reach, [&](uint32_t label, const Vec3& point) {
      const PieceId piece{id, label};
      if (pieces.contains(piece) || found.contains(piece) || is_hidden(piece)) return;
      if (grid.has_near(point)) found.insert(piece);
    });
  }
  return found;
}

void grow_selection(const Document& document, PieceMap& looks) {
  const std::set<PieceId> selected = selected_set(looks);
  for (const PieceId& id : neighbours_of(selected, document.world(), neighbour_reach(document), looks))
    looks[id].selected = true;
}

void shrink_selection(const Document& document, PieceMap& looks) {
  const World& world = document.world();
  const std::vector<PieceId> others = other_pieces(world, looks);
  for (const PieceId& id :
       neighbours_of({others.begin(), others.end()}, world, neighbour_reach(document), looks))
    looks[id].selected = false;
}

std::unique_ptr<Interaction> press_on_pieces(Workspace& workspace, SelectionShape shape) {
  return std::make_unique<PressOnPieces>(workspace, shape);
}

}  // namespace kerf
