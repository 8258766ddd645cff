#include "ui/editor/pieces/rubber_band.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <optional>

#include "ui/render/bodies/body_looks.h"
#include "ui/window/imgui_vector.h"
#include "ui/window/theme.h"

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

// Whether the triangle has a point in the box. Method: separating axes, of which the sides of the box and
// those of the triangle are enough for two convex polygons.
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

// Decides piece by piece of one body, and looks at no more faces of a piece than that takes.
class PiecesOfBody {
 public:
  PiecesOfBody(BodyId id, const Body& body, const ViewOptions& options)
      : body_(body), looks_(id, options), decided_(body.pieces.size()), chosen_(body.pieces.size()) {
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
      if (!touching) chosen_[label] = true;
      const bool in = seen && (touching ? touches(band, *seen) : contains(band, *seen));
      if (in != touching) continue;
      decided_[label] = true;
      chosen_[label] = touching;
    }
  }
  bool chosen(uint32_t label) const { return chosen_[label]; }

 private:
  // None where one lies behind the eye.
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
  std::vector<char> decided_, chosen_;  // by label
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
      if (pieces.chosen(label)) found.push_back({id, label});
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

}  // namespace kerf
