#include "core/laser/compensation.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "core/base/assert.h"
#include "core/base/deterministic_math.h"
#include "core/laser/segment_grid.h"

namespace kerf {

namespace {

// Lengths relative to the radius. A point of the offset line may be this much nearer to the source than the
// radius: twice the sagitta of a chord of a round corner, so that the corner itself is never removed.
constexpr double kOffsetSlack = 2 * kOffsetChord;
// Ends of parts that are this close belong together, and shorter parts are dropped: both come from crossings
// at angles so flat that the distances on both sides are within the slack.
constexpr double kOffsetGap = 0.05;

Vec2 left_of(Vec2 v) { return {-v.y, v.x}; }

// The segments of a line, the closing one included.
std::vector<Segment2> segments_of(const DrawnLine& line) {
  std::vector<Segment2> segments;
  const size_t n = line.points.size();
  for (size_t i = 0; i + (line.closed ? 0 : 1) < n; ++i) {
    const Segment2 segment{line.points[i], line.points[(i + 1) % n]};
    if (segment.begin != segment.end) segments.push_back(segment);
  }
  return segments;
}

// The parallel of a line before crossings are removed.
class RawOffset {
 public:
  RawOffset(const std::vector<Segment2>& source, bool closed, double signed_radius)
      : source_(source), closed_(closed), radius_(signed_radius) {}

  // Returns the corners; of a closed line the last one joins the first.
  std::vector<Vec2> points() {
    KERF_ASSERT(!source_.empty());
    const size_t n = source_.size();
    if (!closed_) add(source_.front().begin + shift(0));
    for (size_t i = 0; i + (closed_ ? 0 : 1) < n; ++i) join(i, (i + 1) % n);
    if (!closed_) add(source_.back().end + shift(n - 1));
    while (closed_ && points_.size() > 1 && points_.back() == points_.front()) points_.pop_back();
    return std::move(points_);
  }

 private:
  Vec2 direction(size_t i) const { return glm::normalize(source_[i].end - source_[i].begin); }
  Vec2 shift(size_t i) const { return radius_ * left_of(direction(i)); }
  double length(size_t i) const { return glm::length(source_[i].end - source_[i].begin); }
  void add(Vec2 point) {
    if (points_.empty() || points_.back() != point) points_.push_back(point);
  }

  // Adds the corner between two successive segments.
  void join(size_t i, size_t next) {
    const Vec2 corner = source_[i].end, d = direction(i), e = direction(next);
    double turn = det::atan2(cross2(d, e), glm::dot(d, e));
    // A line that runs back along itself is rounded at its end on both sides.
    if (cross2(d, e) == 0 && glm::dot(d, e) < 0) turn = radius_ > 0 ? -kPi : kPi;
    if (turn * radius_ >= 0) {
      // Towards the side: the parallels cross, at this distance before the corner.
      const double cosine = 1 + glm::dot(d, e);
      const double before = cosine > 0 ? std::abs(radius_ * cross2(d, e) / cosine) : std::abs(radius_) * 1e9;
      if (before <= 0.5 * std::min(length(i), length(next))) {
        add(corner + radius_ * (left_of(d) + left_of(e)) / cosine);
        return;
      }
    } else {
      const double step = std::sqrt(8 * kOffsetChord);
      const int n = static_cast<int>(std::ceil(std::abs(turn) / step));
      for (int k = 0; k < n; ++k) {
        const auto [sin, cos] = sin_cos(turn * k / n);
        const Vec2 from = shift(i);
        add(corner + cos * from + sin * left_of(from));
      }
      add(corner + shift(next));
      return;
    }
    add(corner + shift(i));
    add(corner + shift(next));
  }

  const std::vector<Segment2>& source_;
  bool closed_;
  double radius_;
  std::vector<Vec2> points_;
};

// A directed part of the raw parallel between two nodes, its corners or crossings.
struct OffsetPart {
  uint32_t from = 0, to = 0;
};

// Removes the parts of the raw parallel that are too near to the source, and chains the others.
class OffsetTrim {
 public:
  OffsetTrim(const std::vector<Segment2>& source, std::vector<Vec2> raw, bool closed, double radius)
      : source_(source), nodes_(std::move(raw)), closed_(closed), radius_(radius) {}

  Result<std::vector<DrawnLine>> run() {
    for (uint32_t i = 0; i < nodes_.size(); ++i) {
      const uint32_t next = (i + 1) % static_cast<uint32_t>(nodes_.size());
      if (next == 0 && (!closed_ || nodes_.size() < 2)) break;
      raw_.push_back({nodes_[i], nodes_[next]});
      ends_.push_back({i, next});
    }
    if (!split())
      return bad_input("compensation: the line is too dense for this radius; simplify the drawing");
    select();
    return chains();
  }

 private:
  // Finds all crossings; false if there are too many pairs to test.
  bool split() {
    constexpr size_t kMaxPairs = 50'000'000;
    double total = 0;
    for (const Segment2& s : raw_) total += glm::length(s.end - s.begin);
    crossings_.resize(raw_.size());
    if (!(total > 0)) return true;
    const SegmentGrid grid(raw_, 2 * total / static_cast<double>(raw_.size()));
    std::vector<std::pair<uint32_t, uint32_t>> pairs;
    if (!grid.neighbours(kMaxPairs, pairs)) return false;
    for (const auto& [i, j] : pairs) {
      if (ends_[i].to != ends_[j].from && ends_[j].to != ends_[i].from) cross(i, j);
    }
    return true;
  }

  void cross(uint32_t i, uint32_t j) {
    const Vec2 a = raw_[i].end - raw_[i].begin, b = raw_[j].end - raw_[j].begin,
               gap = raw_[j].begin - raw_[i].begin;
    const double area = cross2(a, b);
    if (area == 0) return;
    const double t = cross2(gap, b) / area, u = cross2(gap, a) / area;
    if (!(0 <= t && t <= 1 && 0 <= u && u <= 1)) return;
    const auto node = static_cast<uint32_t>(nodes_.size());
    nodes_.push_back(raw_[i].begin + t * a);
    crossings_[i].push_back({t, node});
    crossings_[j].push_back({u, node});
  }

  // Keeps the parts that are far enough from the source.
  void select() {
    const SegmentGrid grid(source_, radius_);
    const double least = (1 - kOffsetSlack) * radius_;
    for (uint32_t i = 0; i < raw_.size(); ++i) {
      std::sort(crossings_[i].begin(), crossings_[i].end());
      OffsetPart part = ends_[i];
      crossings_[i].push_back({1, part.to});
      for (const auto& [t, node] : crossings_[i]) {
        part.to = node;
        const Vec2 a = nodes_[part.from], b = nodes_[part.to];
        const auto is_near = [&](double share) { return grid.is_near(a + share * (b - a), least); };
        if (part.from != part.to && !is_near(0.5) && !is_near(0.25) && !is_near(0.75)) parts_.push_back(part);
        part.from = node;
      }
    }
  }

  // Removes short parts that end where no other begins, or begin where none ends.
  void drop_dead_ends() {
    std::vector<uint32_t> begins(nodes_.size(), 0), ends(nodes_.size(), 0);
    for (const OffsetPart& part : parts_) {
      ++begins[part.from];
      ++ends[part.to];
    }
    for (size_t before = 0; before != parts_.size();) {
      before = parts_.size();
      std::erase_if(parts_, [&](const OffsetPart& part) {
        const bool dead = begins[part.to] == 0 || ends[part.from] == 0;
        if (!dead || glm::length(nodes_[part.to] - nodes_[part.from]) > kOffsetGap * radius_) return false;
        --begins[part.from];
        --ends[part.to];
        return true;
      });
    }
  }

  std::vector<DrawnLine> chains() {
    if (closed_) drop_dead_ends();
    for (uint32_t i = 0; i < parts_.size(); ++i) at_[parts_[i].from].push_back(i);
    used_.resize(parts_.size(), false);
    std::vector<DrawnLine> lines;
    // Parts that nothing leads to begin open chains; the others are closed.
    std::vector<bool> is_led_to(nodes_.size(), false);
    for (const OffsetPart& part : parts_) is_led_to[part.to] = true;
    for (const bool open : {true, false}) {
      for (uint32_t i = 0; i < parts_.size(); ++i) {
        if (!used_[i] && (!open || !is_led_to[parts_[i].from])) add_chain(i, lines);
      }
    }
    return lines;
  }

  void add_chain(uint32_t first, std::vector<DrawnLine>& lines) {
    KERF_ASSERT(!used_[first]);
    DrawnLine line;
    double length = 0;
    std::optional<uint32_t> part = first;
    const uint32_t start = parts_[first].from;
    uint32_t end = start;
    while (part) {
      used_[*part] = true;
      line.points.push_back(nodes_[parts_[*part].from]);
      end = parts_[*part].to;
      length += glm::length(nodes_[end] - nodes_[parts_[*part].from]);
      part = end == start ? std::nullopt : next_part(end);
    }
    line.closed =
        end == start || (closed_ && glm::length(nodes_[end] - nodes_[start]) < kOffsetGap * radius_ &&
                         length > 4 * kOffsetGap * radius_);
    if (end != start) line.points.push_back(nodes_[end]);
    line.points.erase(std::unique(line.points.begin(), line.points.end()), line.points.end());
    if (length > kOffsetGap * radius_ && line.points.size() > (line.closed ? 2 : 1))
      lines.push_back(std::move(line));
  }

  std::optional<uint32_t> next_part(uint32_t node) const {
    const auto found = at_.find(node);
    if (found == at_.end()) return std::nullopt;
    for (const uint32_t i : found->second) {
      if (!used_[i]) return i;
    }
    return std::nullopt;
  }

  const std::vector<Segment2>& source_;
  std::vector<Vec2> nodes_;
  bool closed_;
  double radius_;
  std::vector<Segment2> raw_;
  std::vector<OffsetPart> ends_;                                     // of each raw segment
  std::vector<std::vector<std::pair<double, uint32_t>>> crossings_;  // crossings on each raw segment
  std::vector<OffsetPart> parts_;
  std::map<uint32_t, std::vector<uint32_t>> at_;  // parts by the node where they begin
  std::vector<bool> used_;
};

}  // namespace

Result<std::vector<DrawnLine>> offset_line(const DrawnLine& line, PathSide side, double radius) {
  KERF_ASSERT(side != PathSide::kNone && radius > 0);
  const std::vector<Segment2> source = segments_of(line);
  if (source.empty()) return std::vector<DrawnLine>();
  RawOffset raw(source, line.closed, side == PathSide::kLeft ? radius : -radius);
  auto lines = OffsetTrim(source, raw.points(), line.closed, radius).run();
  if (!lines) return lines.error();
  for (DrawnLine& made : *lines) made.layer = line.layer;
  return lines;
}

}  // namespace kerf
