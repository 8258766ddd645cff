#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "core/base/assert.h"
#include "core/laser/compensation.h"
#include "core/laser/segment_grid.h"

namespace kerf {

namespace {

// Returns true if a closed line encloses a point, by the even-odd rule.
bool encloses(const DrawnLine& line, Vec2 point) {
  bool inside = false;
  const std::vector<Vec2>& p = line.points;
  for (size_t i = 0, j = p.size() - 1; i < p.size(); j = i++) {
    if ((p[i].y > point.y) == (p[j].y > point.y)) continue;
    const double side = cross2(p[j] - p[i], point - p[i]);
    if ((side > 0) == (p[j].y > p[i].y)) inside = !inside;
  }
  return inside;
}

double signed_area(const DrawnLine& line) {
  double area = 0;
  const std::vector<Vec2>& p = line.points;
  for (size_t i = 0; i < p.size(); ++i) area += 0.5 * cross2(p[i] - p[0], p[(i + 1) % p.size()] - p[0]);
  return area;
}

// How many closed lines are around a line, and the smallest of them.
struct Nesting {
  size_t depth = 0;
  std::optional<size_t> parent;
};

// Returns the nesting of the first point of each line.
std::vector<Nesting> nesting_of(const std::vector<DrawnLine>& lines) {
  std::vector<PlaneBounds> bounds;
  std::vector<double> areas;
  for (const DrawnLine& line : lines) {
    bounds.push_back(*bounds_of({line}));
    areas.push_back(std::abs(signed_area(line)));
  }
  std::vector<Nesting> nesting(lines.size());
  for (size_t i = 0; i < lines.size(); ++i) {
    const Vec2 point = lines[i].points.front();
    for (size_t j = 0; j < lines.size(); ++j) {
      if (i == j || !lines[j].closed) continue;
      const bool outside = point.x < bounds[j].min.x || point.x > bounds[j].max.x ||
                           point.y < bounds[j].min.y || point.y > bounds[j].max.y;
      if (outside || !encloses(lines[j], point)) continue;
      ++nesting[i].depth;
      if (!nesting[i].parent || areas[j] < areas[*nesting[i].parent]) nesting[i].parent = j;
    }
  }
  return nesting;
}

// Returns the indices of the lines by descending depth, in their order within a depth.
std::vector<size_t> inner_first(const std::vector<Nesting>& nesting) {
  std::vector<size_t> order(nesting.size());
  std::iota(order.begin(), order.end(), size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](size_t a, size_t b) { return nesting[a].depth > nesting[b].depth; });
  return order;
}

// Measures positions on a line by their distance along it from the first point.
class ArcLength {
 public:
  explicit ArcLength(const std::vector<Vec2>& points) : points_(points), at_(1, 0.0) {
    KERF_ASSERT(!points.empty());
    for (size_t i = 1; i < points.size(); ++i)
      at_.push_back(at_.back() + glm::length(points[i] - points[i - 1]));
  }

  double total() const { return at_.back(); }

  // Returns the points of the part between two distances. Precondition: 0 <= from < to <= total.
  std::vector<Vec2> part(double from, double to) const {
    std::vector<Vec2> part{at(from)};
    for (size_t i = 0; i < points_.size(); ++i) {
      if (at_[i] > from && at_[i] < to && points_[i] != part.back()) part.push_back(points_[i]);
    }
    if (at(to) != part.back()) part.push_back(at(to));
    return part;
  }

 private:
  Vec2 at(double distance) const {
    const size_t next = static_cast<size_t>(std::upper_bound(at_.begin(), at_.end(), distance) - at_.begin());
    if (next == at_.size()) return points_.back();
    const double share = (distance - at_[next - 1]) / (at_[next] - at_[next - 1]);
    return points_[next - 1] + share * (points_[next] - points_[next - 1]);
  }

  const std::vector<Vec2>& points_;
  std::vector<double> at_;
};

// Makes the strokes of one drawing.
class ToolpathMaker {
 public:
  ToolpathMaker(std::vector<DrawnLine> lines, const ToolpathOptions& options)
      : options_(options), lines_(std::move(lines)) {
    if (options.side != PathSide::kNone) alternate_directions(lines_);
    order_inner_first(lines_);
    for (const DrawnLine& line : lines_) {
      for (size_t i = 0; i + (line.closed ? 0 : 1) < line.points.size(); ++i)
        outlines_.push_back({line.points[i], line.points[(i + 1) % line.points.size()]});
    }
    if (options.lead_in > 0) near_.emplace(outlines_, options.radius);
  }

  Result<Toolpath> run() {
    for (const DrawnLine& line : lines_) {
      if (options_.side == PathSide::kNone) {
        add_line(line);
        continue;
      }
      const auto offset = offset_line(line, options_.side, options_.radius);
      if (!offset) return offset.error();
      if (offset->empty()) ++vanished_;
      for (const DrawnLine& made : *offset) add_line(made);
    }
    note(vanished_, "is narrower than the beam and was left out",
         "are narrower than the beam and were left out");
    note(without_entry_, "has no room for an entry", "have no room for an entry");
    note(without_tabs_, "is too short for the tabs", "are too short for the tabs");
    return std::move(path_);
  }

 private:
  void note(size_t count, const char* one, const char* many) {
    if (count == 0) return;
    path_.notes.push_back(count == 1 ? std::string("1 line ") + one
                                     : std::to_string(count) + " lines " + many);
  }

  void add_line(const DrawnLine& line) {
    if (!line.closed) {
      add_stroke(line.points, line.layer);
      return;
    }
    std::vector<Vec2> points = options_.lead_in > 0 ? from_entry(line.points) : line.points;
    points.push_back(points.front());
    const ArcLength lengths(points);
    const double period = lengths.total() / std::max(options_.tabs, 1);
    const double gap = options_.tab_width + 2 * options_.radius;
    if (options_.tabs == 0 || period <= gap) {
      without_tabs_ += options_.tabs > 0 ? 1 : 0;
      add_stroke(std::move(points), line.layer);
      return;
    }
    for (int i = 0; i < options_.tabs; ++i) {
      const double end = i + 1 == options_.tabs ? lengths.total() : period * (i + 1);
      add_stroke(lengths.part(period * i, end - gap), line.layer);
    }
  }

  // Returns the closed line from a point with room for the entry: the middle of a long segment.
  std::vector<Vec2> from_entry(std::vector<Vec2> points) const {
    constexpr size_t kMaxTried = 64;
    const size_t n = points.size();
    std::vector<size_t> order(n);
    std::iota(order.begin(), order.end(), size_t{0});
    const auto length = [&](size_t i) { return glm::length(points[(i + 1) % n] - points[i]); };
    std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) { return length(a) > length(b); });
    for (size_t k = 0; k < std::min(n, kMaxTried); ++k) {
      const size_t i = order[k];
      const Vec2 middle = 0.5 * (points[i] + points[(i + 1) % n]);
      if (!entry(middle, points[(i + 1) % n])) continue;
      std::rotate(points.begin(), points.begin() + static_cast<std::ptrdiff_t>((i + 1) % n), points.end());
      points.insert(points.begin(), middle);
      break;
    }
    return points;
  }

  // Returns the point where the entry to a stroke begins; nullopt if the beam would touch a line on the way.
  std::optional<Vec2> entry(Vec2 start, Vec2 next) const {
    KERF_ASSERT(near_.has_value());
    constexpr int kSamples = 8;
    const Vec2 d = glm::normalize(next - start), left{-d.y, d.x};
    const Vec2 away = options_.side == PathSide::kLeft ? left : -left;
    for (int i = 1; i <= kSamples; ++i) {
      const double share = static_cast<double>(i) / kSamples;
      if (near_->is_near(start + share * options_.lead_in * away, (1 - 2 * kOffsetChord) * options_.radius))
        return std::nullopt;
    }
    return start + options_.lead_in * away;
  }

  void add_stroke(std::vector<Vec2> points, const std::string& layer) {
    KERF_ASSERT(points.size() >= 2);
    if (options_.lead_in > 0) {
      if (const auto from = entry(points[0], points[1])) {
        points.insert(points.begin(), *from);
      } else {
        ++without_entry_;
      }
    }
    path_.strokes.push_back({std::move(points), false, layer});
  }

  const ToolpathOptions& options_;
  std::vector<DrawnLine> lines_;
  std::vector<Segment2> outlines_;
  std::optional<SegmentGrid> near_;
  Toolpath path_;
  size_t vanished_ = 0, without_entry_ = 0, without_tabs_ = 0;
};

}  // namespace

void order_inner_first(std::vector<DrawnLine>& lines) {
  std::vector<DrawnLine> sorted;
  for (const size_t i : inner_first(nesting_of(lines))) sorted.push_back(std::move(lines[i]));
  lines = std::move(sorted);
}

void alternate_directions(std::vector<DrawnLine>& lines) {
  const std::vector<Nesting> nesting = nesting_of(lines);
  std::vector<size_t> order = inner_first(nesting);
  std::reverse(order.begin(), order.end());  // each after the line around it
  for (const size_t i : order) {
    if (!lines[i].closed || !nesting[i].parent) continue;
    if (signed_area(lines[*nesting[i].parent]) * signed_area(lines[i]) > 0)
      std::reverse(lines[i].points.begin(), lines[i].points.end());
  }
}

Result<Toolpath> make_toolpath(std::vector<DrawnLine> lines, const ToolpathOptions& options) {
  KERF_ASSERT(options.radius > 0 || (options.side == PathSide::kNone && options.tabs == 0));
  KERF_ASSERT(options.lead_in == 0 || options.side != PathSide::kNone);
  constexpr size_t kMaxLines = 50'000;
  if (lines.size() > kMaxLines)
    return bad_input("compensation and tabs: there are more than 50 000 lines; use fewer or join them");
  return ToolpathMaker(std::move(lines), options).run();
}

}  // namespace kerf
