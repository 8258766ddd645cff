#include "core/laser/segment_grid.h"

#include <algorithm>
#include <cmath>

#include "core/base/assert.h"

namespace kerf {

double distance_to(const Segment2& segment, Vec2 point) {
  const Vec2 along = segment.end - segment.begin;
  const double length2 = glm::dot(along, along);
  const double t = length2 > 0 ? std::clamp(glm::dot(point - segment.begin, along) / length2, 0.0, 1.0) : 0.0;
  return glm::length(point - segment.begin - t * along);
}

SegmentGrid::SegmentGrid(const std::vector<Segment2>& segments, double cell)
    : segments_(segments), cell_(cell) {
  KERF_ASSERT(cell > 0);
  constexpr double kMaxCells = 5e6, kMaxAcross = 1e9;
  double total = 0, extent = 0;
  if (!segments.empty()) origin_ = segments.front().begin;
  for (const Segment2& s : segments) {
    total += glm::length(s.end - s.begin);
    const Vec2 far = glm::max(glm::abs(s.begin - origin_), glm::abs(s.end - origin_));
    extent = std::max({extent, far.x, far.y});
  }
  cell_ = std::max({cell, total / kMaxCells, extent / kMaxAcross});
  for (uint32_t i = 0; i < segments.size(); ++i) add(i);
  std::sort(entries_.begin(), entries_.end());
}

int64_t SegmentGrid::index_of(double x, double origin) const {
  return static_cast<int64_t>(std::clamp(std::floor((x - origin) / cell_), -1e15, 1e15));
}

// Adds the cells of a segment, column by column.
void SegmentGrid::add(uint32_t index) {
  Vec2 from = segments_[index].begin, to = segments_[index].end;
  if (from.x > to.x) std::swap(from, to);
  const int64_t first = index_of(from.x, origin_.x), last = index_of(to.x, origin_.x);
  const double slope = to.x > from.x ? (to.y - from.y) / (to.x - from.x) : 0;
  for (int64_t column = first; column <= last; ++column) {
    // The part of the segment in this column; rounding may leave it short of the cell at its end.
    const double left = std::max(from.x, origin_.x + static_cast<double>(column) * cell_);
    const double right = std::min(to.x, origin_.x + static_cast<double>(column + 1) * cell_);
    const double y1 = column == first ? from.y : from.y + slope * (left - from.x);
    const double y2 = column == last ? to.y : from.y + slope * (right - from.x);
    const int64_t low = index_of(std::min(y1, y2), origin_.y), high = index_of(std::max(y1, y2), origin_.y);
    for (int64_t row = low; row <= high; ++row) entries_.push_back({{column, row}, index});
  }
}

bool SegmentGrid::is_near(Vec2 point, double distance) const {
  KERF_ASSERT(distance <= cell_);
  const int64_t column = index_of(point.x, origin_.x), row = index_of(point.y, origin_.y);
  for (int64_t x = column - 1; x <= column + 1; ++x) {
    const std::pair<Cell, uint32_t> least{{x, row - 1}, 0};
    for (auto entry = std::lower_bound(entries_.begin(), entries_.end(), least);
         entry != entries_.end() && entry->first.first == x && entry->first.second <= row + 1; ++entry) {
      if (distance_to(segments_[entry->second], point) < distance) return true;
    }
  }
  return false;
}

bool SegmentGrid::neighbours(size_t most, std::vector<std::pair<uint32_t, uint32_t>>& pairs) const {
  for (size_t begin = 0, end = 0; begin < entries_.size(); begin = end) {
    while (end < entries_.size() && entries_[end].first == entries_[begin].first) ++end;
    for (size_t i = begin; i < end; ++i) {
      for (size_t j = i + 1; j < end; ++j) {
        if (pairs.size() >= most) return false;
        pairs.emplace_back(entries_[i].second, entries_[j].second);
      }
    }
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return true;
}

}  // namespace kerf
