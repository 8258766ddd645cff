#include "core/laser/drawing.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <utility>

#include "core/base/assert.h"
#include "core/base/deterministic_math.h"

namespace kerf {

std::optional<std::string> left_out_text(const Drawing& drawing) {
  if (drawing.left_out.empty()) return std::nullopt;
  std::string text;
  for (const auto& [kind, count] : drawing.left_out)
    text += (text.empty() ? "left out: " : ", ") + std::to_string(count) + " " + kind;
  return text;
}

PlaneMap PlaneMap::rotation(double radians) {
  const auto [sin, cos] = sin_cos(radians);
  return {{cos, sin}, {-sin, cos}, Vec2(0)};
}

Vec2 EllipseArc::at(double t) const {
  const auto [sin, cos] = sin_cos(t);
  return centre + cos * x_axis + sin * y_axis;
}

size_t chord_count(double bend, double tolerance, size_t most) {
  KERF_ASSERT(tolerance > 0);
  const double count = std::ceil(std::sqrt(bend / (8 * tolerance)));
  if (!(count > 1)) return 1;
  return count < static_cast<double>(most) ? static_cast<size_t>(count) : std::max<size_t>(most, 1);
}

void DrawingBuilder::add(Vec2 point) {
  if (!fault_.empty()) return;
  constexpr double kMax = DrawingLimits::kMaxCoordinate;
  if (!(std::abs(point.x) <= kMax && std::abs(point.y) <= kMax)) {
    fault_ = "a coordinate is beyond 10 000 km; check the unit and the transforms";
  } else if (points_ >= DrawingLimits::kMaxPoints) {
    fault_ = "the lines have more than 4 000 000 points; use a larger tolerance or a simpler drawing";
  } else if (line_.points.empty() || line_.points.back() != point) {
    line_.points.push_back(point);
    ++points_;
  }
}

void DrawingBuilder::move_to(Vec2 point, const std::string& layer) {
  end_line();
  line_.layer = layer.empty() ? layer_ : layer;
  add(point);
}

void DrawingBuilder::line_to(Vec2 point) { add(point); }

void DrawingBuilder::quadratic_to(Vec2 control, Vec2 end) {
  if (!fault_.empty()) return;
  KERF_ASSERT(!line_.points.empty());
  const Vec2 start = line_.points.back();
  const size_t n = chord_count(2 * glm::length(start - 2.0 * control + end), tolerance_, room());
  for (size_t i = 1; i < n && fault_.empty(); ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(n), s = 1 - t;
    add(s * s * start + 2 * s * t * control + t * t * end);
  }
  add(end);
}

void DrawingBuilder::cubic_to(Vec2 control1, Vec2 control2, Vec2 end) {
  if (!fault_.empty()) return;
  KERF_ASSERT(!line_.points.empty());
  const Vec2 start = line_.points.back();
  const double bend = 6 * std::max(glm::length(start - 2.0 * control1 + control2),
                                   glm::length(control1 - 2.0 * control2 + end));
  const size_t n = chord_count(bend, tolerance_, room());
  for (size_t i = 1; i < n && fault_.empty(); ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(n), s = 1 - t;
    add(s * s * s * start + 3 * s * s * t * control1 + 3 * s * t * t * control2 + t * t * t * end);
  }
  add(end);
}

void DrawingBuilder::arc_to(const EllipseArc& arc, Vec2 end) {
  if (!fault_.empty()) return;
  // The longer semi-axis of the ellipse.
  const double xx = glm::dot(arc.x_axis, arc.x_axis), yy = glm::dot(arc.y_axis, arc.y_axis);
  const double reach =
      std::sqrt(0.5 * (xx + yy) + glm::length(Vec2(0.5 * (xx - yy), glm::dot(arc.x_axis, arc.y_axis))));
  // Three chords or more per turn keep a small circle a polygon.
  const size_t least =
      static_cast<size_t>(std::ceil(std::min(std::abs(arc.sweep), 1e6) / (2 * kPi / 3) - 1e-9));
  const size_t n = std::max(chord_count(arc.sweep * arc.sweep * reach, tolerance_, room()), least);
  for (size_t i = 1; i < n && fault_.empty(); ++i)
    add(arc.at(arc.from + arc.sweep * (static_cast<double>(i) / static_cast<double>(n))));
  add(end);
}

bool DrawingBuilder::returns() const {
  return glm::length(line_.points.back() - line_.points.front()) <= 1e-3 * tolerance_;
}

void DrawingBuilder::close() {
  std::vector<Vec2>& points = line_.points;
  while (points.size() > 1 && returns()) points.pop_back();
  line_.closed = points.size() > 2;
  end_line();
}

void DrawingBuilder::end_line() {
  if (!line_.closed && line_.points.size() > 3 && returns()) return close();
  if (fault_.empty() && line_.points.size() > 1) drawing_.lines.push_back(std::move(line_));
  line_ = {};
}

void DrawingBuilder::ellipse(const EllipseArc& arc, const std::string& layer) {
  move_to(arc.at(arc.from), layer);
  arc_to(arc, arc.at(arc.from));
  close();
}

bool DrawingBuilder::count_element() {
  if (++elements_ > DrawingLimits::kMaxElements && fault_.empty())
    fault_ = "there are more than 1 000 000 elements, with repetitions; use a simpler drawing";
  return fault_.empty();
}

Drawing DrawingBuilder::take() {
  KERF_ASSERT(fault_.empty());
  end_line();
  return std::move(drawing_);
}

std::optional<PlaneBounds> bounds_of(const std::vector<DrawnLine>& lines) {
  if (lines.empty()) return std::nullopt;
  KERF_ASSERT(!lines.front().points.empty());
  PlaneBounds bounds{lines.front().points.front(), lines.front().points.front()};
  for (const DrawnLine& line : lines) {
    for (const Vec2& point : line.points) {
      bounds.min = glm::min(bounds.min, point);
      bounds.max = glm::max(bounds.max, point);
    }
  }
  return bounds;
}

namespace {

// The free ends of open lines, found by their position.
class LineEnds {
 public:
  LineEnds(const std::vector<DrawnLine>& lines, double distance) : lines_(lines), distance_(distance) {
    used_.resize(lines.size(), false);
    for (size_t i = 0; i < lines.size(); ++i) {
      if (lines[i].closed) continue;
      ends_.emplace(cell(lines[i].points.front()), i);
      ends_.emplace(cell(lines[i].points.back()), i);
    }
  }

  bool used(size_t line) const { return used_[line]; }
  // Removes the ends of the line. Precondition: it is open.
  void use(size_t line) {
    KERF_ASSERT(!lines_[line].closed && !used_[line]);
    used_[line] = true;
    for (const Vec2 end : {lines_[line].points.front(), lines_[line].points.back()})
      ends_.erase({cell(end), line});
  }

  // Finds the unused line of the layer with an end at the point, the first in the drawing.
  std::optional<size_t> find(Vec2 point, const std::string& layer) const {
    std::optional<size_t> found;
    const auto [column, row] = cell(point);
    for (int64_t x = column - 1; x <= column + 1; ++x) {
      for (int64_t y = row - 1; y <= row + 1; ++y) {
        const Cell at{x, y};
        for (auto entry = ends_.lower_bound({at, 0}); entry != ends_.end() && entry->first == at; ++entry) {
          const size_t i = entry->second;
          if (found && *found <= i) break;
          if (lines_[i].layer != layer) continue;
          if (meets(lines_[i].points.front(), point) || meets(lines_[i].points.back(), point)) found = i;
        }
      }
    }
    return found;
  }
  bool meets(Vec2 a, Vec2 b) const { return glm::length(a - b) < distance_; }

 private:
  using Cell = std::pair<int64_t, int64_t>;

  // Precondition: coordinates below DrawingLimits::kMaxCoordinate. Cells are limited to 2^53 of them.
  Cell cell(Vec2 point) const {
    const auto index = [&](double x) {
      return static_cast<int64_t>(std::clamp(std::floor(x / distance_), -0x1p53, 0x1p53));
    };
    return {index(point.x), index(point.y)};
  }

  const std::vector<DrawnLine>& lines_;
  double distance_;
  std::vector<bool> used_;
  std::set<std::pair<Cell, size_t>> ends_;
};

// Appends lines to the end of `line` while one begins or ends there.
void extend_line(DrawnLine& line, const std::vector<DrawnLine>& lines, LineEnds& ends) {
  while (!ends.meets(line.points.front(), line.points.back()) || line.points.size() < 3) {
    const auto next = ends.find(line.points.back(), line.layer);
    if (!next) return;
    ends.use(*next);
    std::vector<Vec2> points = lines[*next].points;
    if (!ends.meets(points.front(), line.points.back())) std::reverse(points.begin(), points.end());
    for (size_t i = 1; i < points.size(); ++i) {
      if (points[i] != line.points.back()) line.points.push_back(points[i]);
    }
  }
}

}  // namespace

void join_lines(std::vector<DrawnLine>& lines, double distance) {
  KERF_ASSERT(distance > 0);
  LineEnds ends(lines, distance);
  std::vector<DrawnLine> joined;
  for (size_t i = 0; i < lines.size(); ++i) {
    if (ends.used(i)) continue;
    DrawnLine line = lines[i];
    if (!line.closed) {
      ends.use(i);
      extend_line(line, lines, ends);
      if (!ends.meets(line.points.front(), line.points.back())) {
        std::reverse(line.points.begin(), line.points.end());
        extend_line(line, lines, ends);
        std::reverse(line.points.begin(), line.points.end());
      }
      if (line.points.size() > 3 && ends.meets(line.points.front(), line.points.back())) {
        line.points.pop_back();
        while (line.points.back() == line.points.front()) line.points.pop_back();
        line.closed = line.points.size() > 2;
      }
    }
    joined.push_back(std::move(line));
  }
  lines = std::move(joined);
}

std::string text_position(std::string_view text, size_t offset) {
  offset = std::min(offset, text.size());
  size_t line = 1, begin = 0;
  for (size_t i = 0; i < offset; ++i) {
    if (text[i] != '\n' && (text[i] != '\r' || (i + 1 < text.size() && text[i + 1] == '\n'))) continue;
    ++line;
    begin = i + 1;
  }
  return "line " + std::to_string(line) + ", column " + std::to_string(offset - begin + 1);
}

}  // namespace kerf
