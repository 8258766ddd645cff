#include "core/walls/outline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "core/base/assert.h"
#include "core/base/deterministic_math.h"

namespace kerf {

namespace {

// Relative to the radius. Sides that nearly coincide, such as those of collinear moves, are distinguished by
// the depth of a point in another region. Where an arc leaves a line at a small angle, the depth grows with
// the square of the length, so kDepth corresponds to a length of 1.4e-5. It exceeds the errors of the angles.
constexpr double kDepth = 1e-10, kMinPiece = 1e-4, kLargestGap = 1e-3;

double squared_distance(Vec2 p, const DiscMove& m) {
  const Vec2 way = m.to - m.from, from = p - m.from;
  const double length2 = glm::dot(way, way), along = glm::dot(from, way);
  if (!(along > 0)) return glm::dot(from, from);
  if (along >= length2) return glm::dot(p - m.to, p - m.to);
  const double area = cross2(way, from);
  return area * area / length2;
}

Vec2 on_circle(Vec2 centre, double radius, double angle) {
  const SinCos at = sin_cos(angle);
  return centre + radius * Vec2(at.cos, at.sin);
}

OutlinePiece line(Vec2 from, Vec2 to, uint32_t side) {
  return {from, to, {}, 0, 0, 0, glm::length(to - from), side};
}

OutlinePiece arc(Vec2 centre, double radius, double angle, double turn, uint32_t side) {
  KERF_ASSERT(radius > 0 && turn > 0);
  return {on_circle(centre, radius, angle),
          on_circle(centre, radius, angle + turn),
          centre,
          radius,
          angle,
          turn,
          radius * turn,
          side};
}

// Appends the sides of one region, counter-clockwise.
void append_sides(const DiscMove& m, double radius, uint32_t move, std::vector<OutlinePiece>& out) {
  const Vec2 way = m.to - m.from;
  const double length = glm::length(way);
  if (!(length > kDepth * radius)) return out.push_back(arc(m.from, radius, 0, 2 * kPi, 4 * move + 3));
  const Vec2 left = Vec2(-way.y, way.x) * (radius / length);
  const double angle = det::atan2(left.y, left.x);
  out.push_back(line(m.from - left, m.to - left, 4 * move));
  out.push_back(arc(m.to, radius, angle - kPi, kPi, 4 * move + 1));
  out.push_back(line(m.to + left, m.from + left, 4 * move + 2));
  out.push_back(arc(m.from, radius, angle, kPi, 4 * move + 3));
}

OutlinePiece part_of(const OutlinePiece& p, double from, double to) {
  if (p.radius > 0) return arc(p.centre, p.radius, p.angle + from * p.turn, (to - from) * p.turn, p.side);
  return line(p.at(from), p.at(to), p.side);
}

// Shares of a piece at which it may cross the boundary of the region of a move.
class Crossings {
 public:
  Crossings(const OutlinePiece& piece, const DiscMove& move, double radius) : piece_(piece) {
    for (const Vec2 centre : {move.from, move.to}) cross_circle(centre, radius);
    const Vec2 way = move.to - move.from;
    const double length = glm::length(way);
    if (!(length > 0)) return;
    const Vec2 left = Vec2(-way.y, way.x) * (radius / length);
    cross_line(move.from - left, way / length);
    cross_line(move.from + left, way / length);
  }
  std::vector<double> shares{0.0, 1.0};

 private:
  void note(double share) {
    if (share > 0 && share < 1) shares.push_back(share);
  }
  void record_angle(double angle) {
    double turned = wrapped(angle - piece_.angle);
    if (turned < 0) turned += 2 * kPi;
    note(turned / piece_.turn);
  }
  // Records the roots of x^2 - 2 half x + product = 0.
  void record_roots(double half, double product) {
    const double root2 = half * half - product;
    if (!(root2 > 0)) return;
    note((half - std::sqrt(root2)) / piece_.length);
    note((half + std::sqrt(root2)) / piece_.length);
  }

  void cross_circle(Vec2 centre, double radius) {
    if (piece_.radius > 0) {
      const Vec2 between = centre - piece_.centre;
      const double d2 = glm::dot(between, between), d = std::sqrt(d2);
      const double cosine = (d2 + piece_.radius * piece_.radius - radius * radius) / (2 * d * piece_.radius);
      if (!(std::abs(cosine) < 1)) return;
      const double middle = det::atan2(between.y, between.x);
      const double half = det::atan2(std::sqrt(1 - cosine * cosine), cosine);
      record_angle(middle - half);
      record_angle(middle + half);
    } else if (piece_.length > 0) {
      const Vec2 along = (piece_.to - piece_.from) / piece_.length, between = centre - piece_.from;
      record_roots(glm::dot(along, between), glm::dot(between, between) - radius * radius);
    }
  }
  void cross_line(Vec2 point, Vec2 along) {
    if (piece_.radius > 0) {
      const double height = cross2(along, point - piece_.centre) / piece_.radius;
      if (!(std::abs(height) < 1)) return;
      const double direction = det::atan2(along.y, along.x);
      const double above = det::atan2(height, std::sqrt(1 - height * height));
      record_angle(direction + above);
      record_angle(direction + kPi - above);
    } else if (piece_.length > 0) {
      const Vec2 way = piece_.to - piece_.from;
      const double slope = cross2(along, way);
      if (slope != 0) note(cross2(along, point - piece_.from) / slope);
    }
  }

  const OutlinePiece& piece_;
};

// Part of a piece, as shares of its length.
struct Share {
  double from, to;
};

// Appends the parts of a piece that lie in the region of a move.
void append_covered(const OutlinePiece& piece, const DiscMove& move, double radius, std::vector<Share>& out) {
  std::vector<double> at = Crossings(piece, move, radius).shares;
  std::sort(at.begin(), at.end());
  for (size_t i = 0; i + 1 < at.size(); ++i) {
    if (!(at[i + 1] > at[i])) continue;
    if (squared_distance(piece.at(0.5 * (at[i] + at[i + 1])), move) < radius * radius)
      out.push_back({at[i], at[i + 1]});
  }
}

// All points within `apart` metres of a line.
struct Band {
  DiscMove line;
  double apart = 0;
};

bool cross(const DiscMove& a, const DiscMove& b) {
  const auto splits = [](const DiscMove& m, const DiscMove& other) {
    return cross2(m.to - m.from, other.from - m.from) * cross2(m.to - m.from, other.to - m.from) < 0;
  };
  return splits(a, b) && splits(b, a);
}

// Returns a lower bound of the distance between points of two bands.
double min_distance(const Band& a, const Band& b) {
  if (cross(a.line, b.line)) return 0;
  const double least2 =
      std::min({squared_distance(a.line.from, b.line), squared_distance(a.line.to, b.line),
                squared_distance(b.line.from, a.line), squared_distance(b.line.to, a.line)});
  return std::sqrt(least2) - a.apart - b.apart;
}

// Binary tree over consecutive moves, each node with a band, which is narrow since paths bend slowly.
class MoveTree {
 public:
  struct Node {
    uint32_t first, end;  // moves
    uint32_t halves = 0;  // the first of two child nodes; 0: a single move
    Band band;
  };

  // O(n log n).
  explicit MoveTree(std::span<const DiscMove> moves) {
    KERF_ASSERT(!moves.empty());
    nodes_.push_back({0, static_cast<uint32_t>(moves.size()), 0, {}});
    for (uint32_t i = 0; i < nodes_.size(); ++i) {
      Node& node = nodes_[i];
      const auto [first, end] = std::pair(node.first, node.end);
      node.band.line = {moves[first].from, moves[end - 1].to};
      double apart2 = 0;
      for (const DiscMove& m : moves.subspan(first, end - first)) {
        for (const Vec2 p : {m.from, m.to}) apart2 = std::max(apart2, squared_distance(p, node.band.line));
      }
      node.band.apart = std::sqrt(apart2);
      if (end - first == 1) continue;
      node.halves = static_cast<uint32_t>(nodes_.size());
      const uint32_t middle = first + (end - first) / 2;
      nodes_.push_back({first, middle, 0, {}});
      nodes_.push_back({middle, end, 0, {}});
    }
  }
  const Node& operator[](uint32_t i) const { return nodes_[i]; }

 private:
  std::vector<Node> nodes_;
};

// The parts of a piece not yet covered by a region.
class Uncovered {
 public:
  // Ignores parts of at most `least` metres.
  Uncovered(const OutlinePiece& piece, double least) : piece_(piece), least_(least) { keep({0, 1}); }

  bool empty() const { return parts_.empty(); }
  const std::vector<Share>& parts() const { return parts_; }  // ascending

  // Returns a lower bound of the distance of the uncovered parts from the band.
  double distance(const Band& band) const {
    double least = std::numeric_limits<double>::infinity();
    for (const Band& own : bands_) least = std::min(least, min_distance(own, band));
    return least;
  }

  // Returns true if any part was covered.
  bool cover(std::span<const Share> covered) {
    const std::vector<Share> before = std::exchange(parts_, {});
    bands_.clear();
    bool lost = false;
    for (const Share& part : before) {
      double reached = part.from;
      for (const Share& c : covered) {  // ascending and apart
        if (c.to <= reached || c.from >= part.to) continue;
        lost = true;
        if (c.from > reached) keep({reached, c.from});
        reached = std::max(reached, c.to);
      }
      if (reached < part.to) keep({reached, part.to});
    }
    return lost;
  }

 private:
  void keep(Share part) {
    if (!((part.to - part.from) * piece_.length > least_)) return;
    parts_.push_back(part);
    // A short arc lies near its chord.
    constexpr double kShortArc = kPi / 4;
    const double turn = piece_.turn * (part.to - part.from),
                 count = std::max(1.0, std::ceil(turn / kShortArc));
    Vec2 from = piece_.at(part.from);
    for (double i = 1; i <= count; ++i) {
      const Vec2 to = piece_.at(part.from + (part.to - part.from) * (i / count));
      const double apart =
          piece_.radius > 0 ? piece_.radius - glm::length(0.5 * (from + to) - piece_.centre) : 0;
      bands_.push_back({{from, to}, std::max(apart, 0.0)});
      from = to;
    }
  }

  const OutlinePiece& piece_;
  double least_;
  std::vector<Share> parts_;
  std::vector<Band> bands_;  // in which the parts lie
};

// Removes from a side of a region the parts that other regions cover.
class Coverage {
 public:
  Coverage(std::span<const DiscMove> moves, double radius) : moves_(moves), radius_(radius), tree_(moves) {}

  // Appends the uncovered parts of a side. A part common to two regions belongs to the earlier one. The
  // previous and next moves usually cover most of it; of the others, only those near enough to the
  // remaining parts are computed.
  void append_uncovered(const OutlinePiece& side, std::vector<OutlinePiece>& out) {
    const uint32_t own = side.side / 4;
    KERF_ASSERT(own < moves_.size());
    Uncovered left(side, kMinPiece * radius_);
    if (own + 1 < moves_.size()) cover(left, side, own + 1);
    if (own > 0) cover(left, side, own - 1);
    cover_by_others(left, side, own);
    for (const Share& part : left.parts()) out.push_back(part_of(side, part.from, part.to));
  }

  size_t work = 0;  // visited moves and bands

 private:
  // A region farther away, in radii, covers nothing; exceeds kDepth and rounding.
  static constexpr double kFarther = 1e-8;

  bool cover(Uncovered& left, const OutlinePiece& side, uint32_t move) {
    covered_.clear();
    append_covered(side, moves_[move], radius_ * (move < side.side / 4 ? 1 + kDepth : 1 - kDepth), covered_);
    ++work;
    return left.cover(covered_);
  }

  bool is_far(double distance) const { return distance > (1 + kFarther) * radius_; }

  void cover_by_others(Uncovered& left, const OutlinePiece& side, uint32_t own) {
    uint32_t times = 0;  // number of coverings so far
    waiting_.assign(1, {0, left.distance(tree_[0].band), 0});
    while (!waiting_.empty() && !left.empty()) {
      Waiting at = waiting_.back();
      waiting_.pop_back();
      const MoveTree::Node& node = tree_[at.node];
      if (at.times != times) at.distance = left.distance(node.band);
      ++work;
      if (is_far(at.distance)) continue;
      if (node.halves == 0) {
        if (node.first + 1 < own || node.first > own + 1) times += cover(left, side, node.first);
        continue;
      }
      Waiting nearer{node.halves, left.distance(tree_[node.halves].band), times};
      Waiting farther{node.halves + 1, left.distance(tree_[node.halves + 1].band), times};
      if (farther.distance < nearer.distance) std::swap(nearer, farther);
      waiting_.push_back(farther);
      waiting_.push_back(nearer);
    }
  }

  struct Waiting {
    uint32_t node;
    double distance;
    uint32_t times;  // value of `times` at which the distance was measured
  };

  std::span<const DiscMove> moves_;
  double radius_;
  MoveTree tree_;
  std::vector<Share> covered_;
  std::vector<Waiting> waiting_;
};

// Returns the pieces of the outline, unordered.
Task<std::vector<OutlinePiece>> pieces_of_outline(std::span<const DiscMove> moves, double radius) {
  std::vector<OutlinePiece> pieces, sides;
  if (moves.empty()) co_return pieces;
  Coverage coverage(moves, radius);
  co_await yield_after(moves.size());
  for (uint32_t i = 0; i < moves.size(); ++i) {
    sides.clear();
    append_sides(moves[i], radius, i, sides);
    for (const OutlinePiece& side : sides) coverage.append_uncovered(side, pieces);
    co_await yield_after(4 + std::exchange(coverage.work, 0) / 2);
  }
  co_return pieces;
}

// Finds the piece that starts nearest to a point, within kLargestGap.
class Starts {
 public:
  Starts(const std::vector<OutlinePiece>& pieces, double radius)
      : pieces_(pieces), reach_(kLargestGap * radius) {
    std::vector<uint32_t> order(pieces.size());
    for (uint32_t i = 0; i < order.size(); ++i) order[i] = i;
    std::sort(order.begin(), order.end(),
              [&](uint32_t a, uint32_t b) { return pieces[a].from.x < pieces[b].from.x; });
    for (uint32_t i = 0; i < order.size(); ++i) cells_.push_back({cell(pieces[order[i]].from), i, order[i]});
    std::sort(cells_.begin(), cells_.end());
  }

  // Returns kNoPiece if there is none, and the leftmost of several.
  uint32_t nearest(Vec2 p) const {
    const Cell at = cell(p);
    InCell best{{}, kNoPiece, kNoPiece};
    double nearest = reach_;
    for (const double x : {at[0] - 1, at[0], at[0] + 1}) {
      auto c = std::lower_bound(cells_.begin(), cells_.end(), InCell{{x, at[1] - 1}, 0, 0});
      for (; c != cells_.end() && c->cell[0] == x && c->cell[1] <= at[1] + 1; ++c) {
        const double d = glm::length(pieces_[c->piece].from - p);
        if (!(d < nearest || (d == nearest && d < reach_ && c->rank < best.rank))) continue;
        nearest = d;
        best = *c;
      }
    }
    return best.piece;
  }

  static constexpr uint32_t kNoPiece = std::numeric_limits<uint32_t>::max();

 private:
  using Cell = std::array<double, 2>;  // of a grid as wide as the reach
  struct InCell {
    Cell cell;
    uint32_t rank, piece;
    bool operator<(const InCell& o) const { return std::tie(cell, rank) < std::tie(o.cell, o.rank); }
  };
  Cell cell(Vec2 p) const { return {std::floor(p.x / reach_), std::floor(p.y / reach_)}; }

  const std::vector<OutlinePiece>& pieces_;
  double reach_;
  std::vector<InCell> cells_;  // ascending
};

// Chains each piece to the one that starts nearest to its end. With `around`, pieces also start one way round
// farther.
std::vector<OutlineCurve> chain(const std::vector<OutlinePiece>& pieces, double radius, double around) {
  const Starts starts(pieces, radius);
  const auto next = [&](Vec2 p) {
    uint32_t found = starts.nearest(p);
    for (const double shift : {-around, around}) {
      if (around > 0 && found == Starts::kNoPiece) found = starts.nearest(p + Vec2(0, shift));
    }
    return found;
  };
  std::vector<OutlineCurve> curves;
  std::vector<bool> used(pieces.size());
  for (uint32_t first = 0; first < pieces.size(); ++first) {
    if (used[first]) continue;
    OutlineCurve curve;
    uint32_t i = first;
    while (i < pieces.size() && !used[i]) {
      used[i] = true;
      curve.pieces.push_back(pieces[i]);
      curve.length += pieces[i].length;
      i = next(pieces[i].to);
    }
    if (i != first) return {};
    curves.push_back(std::move(curve));
  }
  return curves;
}

// Distance from moves that their regions cannot reach, in radii.
constexpr double kMarginAround = 2;

double lowest_of(std::span<const DiscMove> moves) {
  double lowest = moves.front().from.y;
  for (const DiscMove& m : moves) lowest = std::min({lowest, m.from.y, m.to.y});
  return lowest;
}

// Returns copies of the moves at all shifts by whole turns that count for two turns from the lowest move.
std::vector<DiscMove> copied_around(std::span<const DiscMove> moves, double radius, double around) {
  const double lowest = lowest_of(moves);
  double highest = lowest;
  for (const DiscMove& m : moves) highest = std::max({highest, m.from.y, m.to.y});
  const double turns = (highest - lowest + 2 * kMarginAround * radius) / around;
  std::vector<DiscMove> copies;
  for (double k = turns > 1 ? -std::ceil(turns) : 0; k <= (turns > 1 ? 1 : 0); ++k) {
    const Vec2 shift(0, k * around);
    for (const DiscMove& m : moves) copies.push_back({m.from + shift, m.to + shift});
  }
  return copies;
}

// Keeps the pieces that start within one turn of several. The turn begins after `low`, in the middle of the
// widest gap between starts, because equal pieces of two copies differ by rounding.
void keep_one_turn(std::vector<OutlinePiece>& pieces, double low, double around) {
  std::vector<double> starts;
  for (const OutlinePiece& piece : pieces) {
    if (low <= piece.from.y && piece.from.y < low + around) starts.push_back(piece.from.y);
  }
  if (starts.empty()) return pieces.clear();
  std::sort(starts.begin(), starts.end());
  double widest = starts.front() + around - starts.back(), begin = starts.back() - around + 0.5 * widest;
  for (size_t i = 1; i < starts.size(); ++i) {
    if (!(starts[i] - starts[i - 1] > widest)) continue;
    widest = starts[i] - starts[i - 1];
    begin = starts[i - 1] + 0.5 * widest;
  }
  if (begin < low) begin += around;
  std::erase_if(pieces, [&](const OutlinePiece& piece) {
    return !(begin <= piece.from.y && piece.from.y < begin + around);
  });
}

}  // namespace

Vec2 OutlinePiece::at(double share) const {
  return radius > 0 ? on_circle(centre, radius, angle + share * turn) : from + share * (to - from);
}

Task<std::vector<OutlineCurve>> outline_of(std::span<const DiscMove> moves, double radius) {
  KERF_ASSERT(radius > 0);
  const std::vector<OutlinePiece> pieces = co_await pieces_of_outline(moves, radius);
  co_return chain(pieces, radius, 0);
}

Task<std::vector<OutlineCurve>> outline_around(std::span<const DiscMove> moves, double radius,
                                               double around) {
  KERF_ASSERT(radius > 0 && around > 0 && !moves.empty());
  const std::vector<DiscMove> copies = copied_around(moves, radius, around);
  std::vector<OutlinePiece> pieces = co_await pieces_of_outline(copies, radius);
  if (copies.size() > moves.size()) keep_one_turn(pieces, lowest_of(moves) - kMarginAround * radius, around);
  const auto sides = static_cast<uint32_t>(4 * moves.size());
  for (OutlinePiece& piece : pieces) piece.side %= sides;
  co_return chain(pieces, radius, around);
}

}  // namespace kerf
