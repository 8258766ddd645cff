#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/result.h"

namespace kerf {

// A plane drawing as chains of straight lines, and the readers of SVG and DXF. Coordinates are in metres, x
// to the right and y up. Readers work on text in memory, are independent of the locale, and never end the
// program: nesting, repetition and numbers are bounded (see DrawingLimits). Errors name the file, the line
// and the column.

// A curve of a drawing as a chain of at least two points. A closed one does not repeat its first point.
struct DrawnLine {
  std::vector<Vec2> points;  // m; successive points differ
  bool closed = false;
  std::string layer;  // of DXF; the colour of the stroke in SVG, "#rrggbb" or a name; or empty
};

struct Drawing {
  std::vector<DrawnLine> lines;  // in the order of the file
  // Centre of the page (SVG), or of the bounding box of the lines (DXF) [m].
  Vec2 middle{0};
  // Number of elements that were not read, by their kind, such as "text" or "HATCH".
  std::map<std::string, size_t> left_out;
};

// Bounds on what a file of any content can make a reader do.
struct DrawingLimits {
  static constexpr size_t kMaxPoints = 4'000'000;
  static constexpr size_t kMaxElements = 1'000'000;  // shapes, with repetitions
  static constexpr int kMaxDepth = 100;              // levels of groups, symbols and blocks
  static constexpr double kMaxCoordinate = 1e7;      // m
};

// Read a drawing from the text of a file. `file` names it in errors. Curves are replaced by chords whose
// distance from the curve is at most `tolerance` [m, > 0]. Fail with bad input. Linear in the file and the
// lines made.
//
// SVG 1.1 and 2: paths, basic shapes, groups, symbols and their uses, transforms, units of CSS (96 px per
// inch) and viewBox. Fills and stroke widths are ignored: each outline is a line.
Result<Drawing> read_svg(std::string_view text, const std::string& file, double tolerance);
// DXF R12 to 2018 in text form: LINE, ARC, CIRCLE, ELLIPSE, LWPOLYLINE, POLYLINE, SPLINE and INSERT of the
// model space, in the unit of the header, else millimetres. Layers that are frozen or off are left out. Lines
// of a layer whose ends meet are joined.
Result<Drawing> read_dxf(std::string_view text, const std::string& file, double tolerance);

// Format lines as a drawing in millimetres: SVG, whose page is centred at the zero of the coordinates, so
// that reading it restores them, and DXF R12 with the layers of the lines.
std::string svg_text(std::span<const DrawnLine> lines);
std::string dxf_text(std::span<const DrawnLine> lines);

// Formats the elements left out: "left out: 2 image, 1 text"; nullopt if there are none.
std::optional<std::string> left_out_text(const Drawing& drawing);

// An affine map of the plane: (x, y) -> origin + x * x_axis + y * y_axis.
struct PlaneMap {
  Vec2 x_axis{1, 0}, y_axis{0, 1}, origin{0};

  Vec2 vector(Vec2 v) const { return v.x * x_axis + v.y * y_axis; }
  Vec2 point(Vec2 p) const { return vector(p) + origin; }
  // Returns the map that applies `inner` first.
  PlaneMap operator*(const PlaneMap& inner) const {
    return {vector(inner.x_axis), vector(inner.y_axis), point(inner.origin)};
  }
  static PlaneMap translation(Vec2 by) { return {{1, 0}, {0, 1}, by}; }
  static PlaneMap scaling(Vec2 by) { return {{by.x, 0}, {0, by.y}, Vec2(0)}; }
  static PlaneMap rotation(double radians);
};

// Part of an ellipse: centre + cos(t) * x_axis + sin(t) * y_axis for t from `from` to `from + sweep` [rad].
struct EllipseArc {
  Vec2 centre{0}, x_axis{1, 0}, y_axis{0, 1};
  double from = 0, sweep = 0;

  Vec2 at(double t) const;
  EllipseArc mapped(const PlaneMap& map) const {
    return {map.point(centre), map.vector(x_axis), map.vector(y_axis), from, sweep};
  }
};

// Returns the number of chords of equal parameter length that approximate a curve within `tolerance`, if the
// length of its second derivative over the unit interval is at most `bend`: n with bend / (8 n^2) <=
// tolerance. At least 1, at most `most`.
size_t chord_count(double bend, double tolerance, size_t most);

// Collects the lines of a drawing and flattens curves. After a coordinate that is not finite or too large, or
// too many points, it ignores all input, and fault() returns the reason.
class DrawingBuilder {
 public:
  // Precondition: tolerance > 0, in metres.
  explicit DrawingBuilder(double tolerance) : tolerance_(tolerance) {}

  // Sets the layer of lines that name none.
  void set_layer(std::string layer) { layer_ = std::move(layer); }
  // Begins a line, ends the current one.
  void move_to(Vec2 point, const std::string& layer = {});
  // Extend the current line. Precondition: it was begun.
  void line_to(Vec2 point);
  void quadratic_to(Vec2 control, Vec2 end);
  void cubic_to(Vec2 control1, Vec2 control2, Vec2 end);
  // Extends the current line from its last point, the start of the arc, to `end`, the end of the arc.
  void arc_to(const EllipseArc& arc, Vec2 end);
  // Closes and ends the current line.
  void close();
  // Ends the current line; one without two different points is dropped.
  void end_line();
  // Adds a closed ellipse.
  void ellipse(const EllipseArc& arc, const std::string& layer = {});

  void leave_out(const std::string& kind) { ++drawing_.left_out[kind]; }
  // Counts an element; false if there are too many.
  bool count_element();

  double tolerance() const { return tolerance_; }
  // The reason why the input is not acceptable, as a clause with the remedy; empty if it is.
  const std::string& fault() const { return fault_; }
  const std::vector<DrawnLine>& lines() const { return drawing_.lines; }

  // Ends the current line and moves the drawing out. Precondition: no fault.
  Drawing take();

 private:
  void add(Vec2 point);
  // Returns true if the current line ends at its start, but for rounding of relative coordinates.
  bool returns() const;
  size_t room() const { return DrawingLimits::kMaxPoints - points_; }

  double tolerance_;
  Drawing drawing_;
  DrawnLine line_;
  std::string layer_, fault_;
  size_t points_ = 0, elements_ = 0;
};

// Returns the bounding box as its lower and upper corner; nullopt without lines.
struct PlaneBounds {
  Vec2 min{0}, max{0};
};
std::optional<PlaneBounds> bounds_of(const std::vector<DrawnLine>& lines);

// Joins open lines of one layer whose ends are closer than `distance` [m, > 0] into longer ones, reversing
// lines where needed, and closes lines whose ends meet. Lines stay in the order of their first parts. O(n log
// n) for n lines.
void join_lines(std::vector<DrawnLine>& lines, double distance);

// Returns where a position of a text is, "line 3, column 14", both counted from 1. Linear in the position.
std::string text_position(std::string_view text, size_t offset);

}  // namespace kerf
