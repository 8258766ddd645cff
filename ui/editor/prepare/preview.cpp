#include "ui/editor/prepare/preview.h"

#include <algorithm>
#include <cmath>

#include "core/base/angle.h"
#include "core/base/assert.h"
#include "core/mesh/surface_distance.h"

namespace kerf {

namespace {

constexpr double kMostDepth = 0.008;  // of the size of the world, from which a wire shines through a surface

std::vector<FaceId> faces_of(const Body& body, uint32_t label) {
  std::vector<FaceId> faces;
  for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
    if (body.mesh.is_live(FaceId(f)) && body.mesh.data(FaceId(f)).piece == label) faces.emplace_back(f);
  }
  return faces;
}

// The faces of a piece where it stands in the world.
std::vector<Triangle> surface_of(const World& world, const PieceId& piece) {
  const Body& body = world.body(piece.body);
  std::vector<Triangle> surface;
  for (const FaceId f : faces_of(body, piece.label)) {
    Triangle t = body.mesh.triangle(f);
    for (Vec3& corner : t) corner = body.placement.to_world(corner);
    surface.push_back(t);
  }
  return surface;
}

void add_statistics(std::span<const Triangle> surface, Preview::Statistics& statistics) {
  double largest = std::cos(radians_of(statistics.least_angle));
  if (statistics.faces == 0) largest = -1;
  for (const Triangle& t : surface) largest = std::max(largest, largest_cosine(t));
  statistics.faces += surface.size();
  statistics.least_angle = degrees_of(std::acos(std::clamp(largest, -1.0, 1.0)));
}

// The sides of the faces of a piece as pairs of vertices, each once.
std::vector<std::pair<uint32_t, uint32_t>> sides_of(const Body& body, uint32_t label) {
  std::vector<std::pair<uint32_t, uint32_t>> sides;
  for (const FaceId f : faces_of(body, label)) {
    const auto corners = body.mesh.corners(f);
    for (size_t i = 0; i < 3; ++i)
      sides.push_back(std::minmax({corners[i].index, corners[(i + 1) % 3].index}));
  }
  std::sort(sides.begin(), sides.end());
  sides.erase(std::unique(sides.begin(), sides.end()), sides.end());
  return sides;
}

// The wire of `made`, which is to be drawn as `shown` is.
DrawnWire::Part wire_of(const World& world, const PieceId& made, const PieceId& shown) {
  const Body& body = world.body(made.body);
  DrawnWire::Part part{.piece = shown, .frame = {}, .edges = {}};
  const auto sides = sides_of(body, made.label);
  KERF_ASSERT(!sides.empty());
  const Positions positions = body.mesh.positions();
  const auto at = [&](uint32_t v) { return body.placement.to_world(positions[v]); };
  Vec3 low = at(sides[0].first), high = low;
  for (const auto& [from, to] : sides) {
    for (const uint32_t v : {from, to}) {
      low = glm::min(low, at(v));
      high = glm::max(high, at(v));
    }
  }
  part.frame = FloatFrame::around(low, high);
  for (const auto& [from, to] : sides) {
    const Vec3 a = at(from), b = at(to);
    part.edges.push_back({part.frame.to_float(a), part.frame.to_float(b)});
    part.mean_edge += glm::length(b - a) / static_cast<double>(sides.size());
  }
  return part;
}

}  // namespace

const char* why_no_preview(const World& world, std::span<const PieceRow> pieces, const Preparation& p) {
  if (const char* why = why_no_preparation(pieces, p)) return why;
  if (world.live_faces() > kMostFacesToPreview) return "More than 400 000 faces are too many for a preview.";
  if (forecast(pieces, p).after.value_or(0) > kMostFacesPreviewed)
    return "More than 1 600 000 faces afterwards are too many for a preview.";
  return nullptr;
}

Result<Preview> make_preview(const World& world, std::span<const PieceRow> pieces, const Preparation& p,
                             const Progress& progress) {
  KERF_ASSERT(why_no_preview(world, pieces, p) == nullptr);
  ProgressShares shares(&progress);
  const Progress preparing = shares.next(0.6), measuring = shares.next(0.4);
  Document document(world);
  document.set_window(0);
  const Outcome outcome = prepare_pieces(document, pieces, p, &preparing);
  if (!outcome) return outcome.error();
  Preview preview;
  auto wire = std::make_shared<DrawnWire>();
  ProgressShares of_pieces(&measuring);
  for (const PieceRow& row : pieces) {
    const Progress own = of_pieces.next(1 / static_cast<double>(pieces.size()));
    const PieceId made = named_after(outcome.delta, row.id);
    const std::vector<Triangle> old = surface_of(world, row.id), now = surface_of(document.world(), made);
    add_statistics(old, preview.before);
    add_statistics(now, preview.after);
    const auto distance = surface_distance(old, now, &own);
    if (!distance) return distance.error();
    preview.distance = std::max(preview.distance, *distance);
    wire->parts.push_back(wire_of(document.world(), made, row.id));
  }
  wire->depth = std::min(preview.distance, kMostDepth * world.loaded_bounds().diagonal());
  preview.wire = std::move(wire);
  return preview;
}

}  // namespace kerf
