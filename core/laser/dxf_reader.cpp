#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/deterministic_math.h"
#include "core/laser/drawing.h"
#include "core/laser/dxf_file.h"
#include "core/laser/spline.h"

namespace kerf {

namespace {

Vec2 quarter_turn(Vec2 v) { return {-v.y, v.x}; }

// A corner of a polyline, with the bulge of the side after it: the tangent of a quarter of its arc's angle,
// positive for counter-clockwise arcs.
struct BulgeCorner {
  Vec2 point{0};
  double bulge = 0;
};

// Returns the arc between two corners. Precondition: the bulge is not zero.
EllipseArc bulge_arc(const BulgeCorner& corner, Vec2 end) {
  const double b = corner.bulge;
  const Vec2 chord = end - corner.point;
  EllipseArc arc;
  arc.centre = 0.5 * (corner.point + end) + (1 - b * b) / (4 * b) * quarter_turn(chord);
  arc.x_axis = corner.point - arc.centre;
  arc.y_axis = quarter_turn(arc.x_axis);
  arc.sweep = 4 * det::atan2(b, 1);
  return arc;
}

// Interprets the entities of a DXF file.
class DxfReader {
 public:
  DxfReader(const DxfFile& file, double tolerance) : file_(file), builder_(tolerance) {}

  Result<Drawing> read() {
    const PlaneMap metres = PlaneMap::scaling(Vec2(file_.unit));
    if (const Status s = draw_all(file_.entities, {metres, "", 0}); !s) return s.error();
    if (!builder_.fault().empty()) return bad_input(file_.name + ": " + builder_.fault());
    Drawing drawing = builder_.take();
    join_lines(drawing.lines, builder_.tolerance());
    if (const auto bounds = bounds_of(drawing.lines)) drawing.middle = 0.5 * (bounds->min + bounds->max);
    return drawing;
  }

 private:
  // How the entities of a block lie in the drawing.
  struct Placing {
    PlaneMap map;
    std::string layer;  // of its entities on the layer 0; empty outside of blocks
    int depth = 0;
  };

  Status draw_all(const std::vector<DxfEntity>& entities, const Placing& placing) {
    for (size_t i = 0; i < entities.size(); ++i) {
      const size_t first = i;
      // The corners of a polyline follow it as entities.
      if (entities[i].type() == "POLYLINE") {
        while (i + 1 < entities.size() && entities[i + 1].type() == "VERTEX") ++i;
      }
      const std::span<const DxfEntity> corners = std::span(entities).subspan(first + 1, i - first);
      if (const Status s = draw(entities[first], corners, placing); !s) return s;
    }
    return Done{};
  }

  Status draw(const DxfEntity& entity, std::span<const DxfEntity> corners, const Placing& placing) {
    if (!builder_.count_element()) return bad_input(file_.name + ": " + builder_.fault());
    const std::string_view type = entity.type();
    if (type == "SEQEND" || type == "VIEWPORT") return Done{};
    const auto paper = entity.whole(67, 0), invisible = entity.whole(60, 0);
    if (!paper) return paper.error();
    if (!invisible) return invisible.error();
    if (*invisible == 1) return Done{};
    if (*paper == 1) {
      builder_.leave_out("element of the paper space");
      return Done{};
    }
    // An entity of a block that is on layer 0 has the layer of the insert.
    std::string layer(entity.text(8));
    if (!placing.layer.empty() && (layer.empty() || layer == "0")) layer = placing.layer;
    if (const auto found = file_.hidden_layer.find(layer);
        found != file_.hidden_layer.end() && found->second) {
      builder_.leave_out("element of a hidden layer");
      return Done{};
    }
    const auto mirrored = is_mirrored(entity);
    if (!mirrored) return mirrored.error();
    if (!*mirrored) {
      builder_.leave_out("tilted " + std::string(type.substr(0, 40)));
      return Done{};
    }
    return draw_kind(entity, corners, **mirrored, {placing.map, layer, placing.depth});
  }

  // Returns true if the plane of the entity is seen from behind, nullopt if it is tilted. A line has no
  // plane: its normal is the direction of its thickness.
  static Result<std::optional<bool>> is_mirrored(const DxfEntity& entity) {
    if (entity.type() == "LINE") return std::optional(false);
    const auto normal = entity.point(210);
    const auto z = entity.number(230, 1);
    if (!normal) return normal.error();
    if (!z) return z.error();
    const double tilt = glm::length(*normal);
    if (!(tilt <= kUnitSlack * std::abs(*z))) return std::optional<bool>();
    return std::optional(*z < 0);
  }

  Status draw_kind(const DxfEntity& entity, std::span<const DxfEntity> corners, bool mirrored,
                   const Placing& placing) {
    const std::string_view type = entity.type();
    Placing own = placing;  // in the coordinates of the plane of the entity
    if (mirrored) own.map = own.map * PlaneMap::scaling({-1, 1});
    if (type == "LINE") return line(entity, placing);
    if (type == "ARC" || type == "CIRCLE") return arc(entity, own);
    if (type == "ELLIPSE") return ellipse(entity, mirrored, placing);
    if (type == "LWPOLYLINE") return light_polyline(entity, own);
    if (type == "POLYLINE") return polyline(entity, corners, own, placing);
    if (type == "SPLINE") return spline(entity, placing);
    if (type == "INSERT") return insert(entity, own);
    builder_.leave_out(std::string(type.substr(0, 40)));
    return Done{};
  }

  Status line(const DxfEntity& entity, const Placing& placing) {
    const auto from = entity.point(10), to = entity.point(11);
    if (!from) return from.error();
    if (!to) return to.error();
    builder_.move_to(placing.map.point(*from), placing.layer);
    builder_.line_to(placing.map.point(*to));
    builder_.end_line();
    return Done{};
  }

  Status arc(const DxfEntity& entity, const Placing& placing) {
    const auto centre = entity.point(10);
    const auto radius = entity.number(40, 0), from = entity.number(50, 0), to = entity.number(51, 360);
    if (!centre) return centre.error();
    for (const auto& number : {radius, from, to}) {
      if (!number) return number.error();
    }
    if (!(*radius > 0)) return entity.wrong("the radius must be greater than zero");
    EllipseArc arc{*centre, {*radius, 0}, {0, *radius}, 0, 2 * kPi};
    if (entity.type() == "CIRCLE") {
      builder_.ellipse(arc.mapped(placing.map), placing.layer);
      return Done{};
    }
    double turn = std::fmod(*to - *from, 360);
    if (turn <= 0) turn += 360;
    arc.from = radians_of(std::fmod(*from, 360));
    arc.sweep = radians_of(turn);
    part_of_ellipse(arc.mapped(placing.map), turn == 360, placing.layer);
    return Done{};
  }

  void part_of_ellipse(const EllipseArc& arc, bool whole, const std::string& layer) {
    if (whole) {
      builder_.ellipse(arc, layer);
      return;
    }
    builder_.move_to(arc.at(arc.from), layer);
    builder_.arc_to(arc, arc.at(arc.from + arc.sweep));
    builder_.end_line();
  }

  Status ellipse(const DxfEntity& entity, bool mirrored, const Placing& placing) {
    const auto centre = entity.point(10), major = entity.point(11);
    const auto ratio = entity.number(40, 1), from = entity.number(41, 0), to = entity.number(42, 2 * kPi);
    if (!centre) return centre.error();
    if (!major) return major.error();
    for (const auto& number : {ratio, from, to}) {
      if (!number) return number.error();
    }
    if (!(*ratio > 0) || *major == Vec2(0)) return entity.wrong("both axes must be longer than zero");
    const Vec2 minor = (mirrored ? -*ratio : *ratio) * quarter_turn(*major);
    double turn = std::fmod(*to - *from, 2 * kPi);
    const bool whole = std::abs(turn) < 1e-9 || std::abs(std::abs(turn) - 2 * kPi) < 1e-9;
    if (whole) turn = 2 * kPi;
    if (turn < 0) turn += 2 * kPi;
    part_of_ellipse(EllipseArc{*centre, *major, minor, std::fmod(*from, 2 * kPi), turn}.mapped(placing.map),
                    whole, placing.layer);
    return Done{};
  }

  void draw_corners(const std::vector<BulgeCorner>& corners, bool closed, const Placing& placing) {
    if (corners.empty()) return;
    builder_.move_to(placing.map.point(corners.front().point), placing.layer);
    for (size_t i = 0; i + (closed ? 0 : 1) < corners.size(); ++i) {
      const Vec2 end = corners[(i + 1) % corners.size()].point;
      if (corners[i].bulge != 0 && corners[i].point != end)
        builder_.arc_to(bulge_arc(corners[i], end).mapped(placing.map), placing.map.point(end));
      builder_.line_to(placing.map.point(end));
    }
    if (closed) builder_.close();
    builder_.end_line();
  }

  Status light_polyline(const DxfEntity& entity, const Placing& placing) {
    std::vector<BulgeCorner> corners;
    for (const DxfGroup& group : entity.groups()) {
      if (group.code != 10 && group.code != 20 && group.code != 42) continue;
      const auto value = entity.number(group);
      if (!value) return value.error();
      if (group.code == 10) corners.push_back({{*value, 0}, 0});
      if (corners.empty()) return entity.wrong("a corner must begin with the group 10");
      if (group.code == 20) corners.back().point.y = *value;
      if (group.code == 42) corners.back().bulge = *value;
    }
    const auto flags = entity.whole(70, 0);
    if (!flags) return flags.error();
    draw_corners(corners, (*flags & 1) != 0, placing);
    return Done{};
  }

  Status polyline(const DxfEntity& entity, std::span<const DxfEntity> vertices, const Placing& own,
                  const Placing& world) {
    constexpr int kClosed = 1, kSpatial = 8, kMeshes = 16 | 64, kSplineFrame = 16;
    const auto flags = entity.whole(70, 0);
    if (!flags) return flags.error();
    if ((*flags & kMeshes) != 0) {
      builder_.leave_out("POLYLINE that is a mesh");
      return Done{};
    }
    std::vector<BulgeCorner> corners;
    for (const DxfEntity& vertex : vertices) {
      const auto kind = vertex.whole(70, 0);
      const auto point = vertex.point(10);
      const auto bulge = vertex.number(42, 0);
      if (!kind) return kind.error();
      if (!point) return point.error();
      if (!bulge) return bulge.error();
      if ((*kind & kSplineFrame) == 0) corners.push_back({*point, *bulge});
    }
    draw_corners(corners, (*flags & kClosed) != 0, (*flags & kSpatial) != 0 ? world : own);
    return Done{};
  }

  Status spline(const DxfEntity& entity, const Placing& placing) {
    Spline spline;
    const auto degree = entity.whole(71, 3);
    if (!degree) return degree.error();
    spline.degree = *degree;
    if (const Status s = unpack(entity.points(10), spline.controls); !s) return s;
    if (const Status s = unpack(entity.numbers(40), spline.knots); !s) return s;
    if (const Status s = unpack(entity.numbers(41), spline.weights); !s) return s;
    if (spline.controls.empty()) {
      builder_.leave_out("SPLINE without control points");
      return Done{};
    }
    if (const auto fault = spline_fault(spline)) return entity.wrong(*fault);
    for (Vec2& control : spline.controls) control = placing.map.point(control);
    const auto flags = entity.whole(70, 0);
    if (!flags) return flags.error();
    add_spline(spline, placing.layer, builder_);
    if ((*flags & 1) != 0) builder_.close();
    builder_.end_line();
    return Done{};
  }

  Status insert(const DxfEntity& entity, const Placing& placing) {
    if (placing.depth >= DrawingLimits::kMaxDepth) return entity.wrong("blocks are nested too deeply");
    const auto block = file_.blocks.find(entity.text(2));
    if (block == file_.blocks.end()) {
      builder_.leave_out("INSERT of a block that is not in the file");
      return Done{};
    }
    const auto at = entity.point(10);
    const auto x = entity.number(41, 1), y = entity.number(42, 1), turn = entity.number(50, 0);
    const auto column = entity.number(44, 0), row = entity.number(45, 0);
    const auto columns = entity.whole(70, 1), rows = entity.whole(71, 1);
    if (!at) return at.error();
    for (const auto& number : {x, y, turn, column, row}) {
      if (!number) return number.error();
    }
    if (!columns) return columns.error();
    if (!rows) return rows.error();
    const PlaneMap turned =
        placing.map * PlaneMap::translation(*at) * PlaneMap::rotation(radians_of(std::fmod(*turn, 360)));
    for (int j = 0; j < std::max(*rows, 1); ++j) {
      for (int i = 0; i < std::max(*columns, 1); ++i) {
        if (!builder_.count_element()) return bad_input(file_.name + ": " + builder_.fault());
        const PlaneMap map = turned * PlaneMap::translation({i * *column, j * *row}) *
                             PlaneMap::scaling({*x, *y}) * PlaneMap::translation(-block->second.base);
        const Status s = draw_all(block->second.entities, {map, placing.layer, placing.depth + 1});
        if (!s) return s;
      }
    }
    return Done{};
  }

  const DxfFile& file_;
  DrawingBuilder builder_;
};

}  // namespace

Result<Drawing> read_dxf(std::string_view text, const std::string& file, double tolerance) {
  DxfFile split;
  if (const Status s = split_dxf(text, file, split); !s) return s.error();
  return DxfReader(split, tolerance).read();
}

}  // namespace kerf
