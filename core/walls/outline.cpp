#include "core/walls/outline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/base/angle.h"
#include "core/base/assert.h"

namespace kerf {

namespace {

// Relative to the radius. Sides that nearly coincide, as those of moves on one line do, are told apart by how
// deep a point lies in another region; at the small angles at which arcs leave lines, the depth grows with
// the square of the length, so that kDepth corresponds to lengths of 1.4e-5. It exceeds the errors of the
// angles.
constexpr double kDepth = 1e-10, kLeastPiece = 1e-4, kLargestGap = 1e-3;

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
  return {on_circle(centre, radius, angle),
          on_circle(centre, radius, angle + turn),
          centre,
          radius,
          angle,
          turn,
          radius * turn,
          side};
}

// The sides of one region, counter-clockwise.
void append_sides(const DiscMove& m, double radius, uint32_t move, std::vector<OutlinePiece>& out) {
  const Vec2 way = m.to - m.from;
  const double length = glm::length(way);
  if (!(length > kDepth * radius)) return out.push_back(arc(m.from, radius, 0, 2 * kPi, 4 * move + 3));
  const Vec2 left = Vec2(-way.y, way.x) * (radius / length);
  const double angle = arc_tangent(left.y, left.x);
  out.push_back(line(m.from - left, m.to - left, 4 * move));
  out.push_back(arc(m.to, radius, angle - kPi, kPi, 4 * move + 1));
  out.push_back(line(m.to + left, m.from + left, 4 * move + 2));
  out.push_back(arc(m.from, radius, angle, kPi, 4 * move + 3));
}

OutlinePiece part_of(const OutlinePiece& p, double from, double to) {
  if (p.radius > 0) return arc(p.centre, p.radius, p.angle + from * p.turn, (to - from) * p.turn, p.side);
  return line(p.at(from), p.at(to), p.side);
}

// The shares of a piece at which it may cross the boundary of the region of a move.
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
  void note_angle(double angle) {
    double turned = wrapped(angle - piece_.angle);
    if (turned < 0) turned += 2 * kPi;
    note(turned / piece_.turn);
  }
  // Of the equation x^2 - 2 half x + product = 0.
  void note_roots(double half, double product) {
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
      const double middle = arc_tangent(between.y, between.x);
      const double half = arc_tangent(std::sqrt(1 - cosine * cosine), cosine);
      note_angle(middle - half);
      note_angle(middle + half);
    } else if (piece_.length > 0) {
      const Vec2 along = (piece_.to - piece_.from) / piece_.length, between = centre - piece_.from;
      note_roots(glm::dot(along, between), glm::dot(between, between) - radius * radius);
    }
  }
  void cross_line(Vec2 point, Vec2 along) {
    if (piece_.radius > 0) {
      const double height = cross2(along, point - piece_.centre) / piece_.radius;
      if (!(std::abs(height) < 1)) return;
      const double direction = arc_tangent(along.y, along.x);
      const double above = arc_tangent(height, std::sqrt(1 - height * height));
      note_angle(direction + above);
      note_angle(direction + kPi - above);
    } else if (piece_.length > 0) {
      const Vec2 way = piece_.to - piece_.from;
      const double slope = cross2(along, way);
      if (slope != 0) note(cross2(along, point - piece_.from) / slope);
    }
  }

  const OutlinePiece& piece_;
};

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

// Appends what is left of a piece.
void append_uncovered(const OutlinePiece& piece, std::vector<Share>& covered, double least,
                      std::vector<OutlinePiece>& out) {
  std::sort(covered.begin(), covered.end(), [](const Share& a, const Share& b) { return a.from < b.from; });
  double reached = 0;
  const auto add = [&](double to) {
    if ((to - reached) * piece.length > least) out.push_back(part_of(piece, reached, to));
  };
  for (const Share& c : covered) {
    add(c.from);
    reached = std::max(reached, c.to);
  }
  add(1);
}

struct Box {
  Vec2 low, high;
  bool meets(const Box& o) const {
    return low.x <= o.high.x && o.low.x <= high.x && low.y <= o.high.y && o.low.y <= high.y;
  }
};

// The pieces of the outline in no order. Of two regions, the later one leaves to the earlier one what they
// have in common.
Resumable<std::vector<OutlinePiece>> pieces_of_outline(std::span<const DiscMove> moves, double radius) {
  std::vector<Box> boxes;
  for (const DiscMove& m : moves)
    boxes.push_back(
        {glm::min(m.from, m.to) - Vec2(1.01 * radius), glm::max(m.from, m.to) + Vec2(1.01 * radius)});
  std::vector<OutlinePiece> pieces, sides;
  std::vector<Share> covered;
  std::vector<uint32_t> near;
  for (uint32_t i = 0; i < moves.size(); ++i) {
    near.clear();
    for (uint32_t k = 0; k < moves.size(); ++k) {
      if (k != i && boxes[i].meets(boxes[k])) near.push_back(k);
    }
    sides.clear();
    append_sides(moves[i], radius, i, sides);
    for (const OutlinePiece& side : sides) {
      covered.clear();
      for (const uint32_t k : near)
        append_covered(side, moves[k], radius * (k < i ? 1 + kDepth : 1 - kDepth), covered);
      append_uncovered(side, covered, kLeastPiece * radius, pieces);
    }
    co_await worked(4 + moves.size() / 64 + 2 * near.size());
  }
  co_return pieces;
}

// Chains pieces, each to the one that starts nearest to its end.
std::vector<OutlineCurve> chain(const std::vector<OutlinePiece>& pieces, double radius) {
  std::vector<uint32_t> order(pieces.size());
  for (uint32_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(),
            [&](uint32_t a, uint32_t b) { return pieces[a].from.x < pieces[b].from.x; });
  const auto after = [&](const OutlinePiece& p) {
    const double reach = kLargestGap * radius;
    auto at = std::lower_bound(order.begin(), order.end(), p.to.x - reach,
                               [&](uint32_t i, double x) { return pieces[i].from.x < x; });
    uint32_t best = std::numeric_limits<uint32_t>::max();
    double nearest = reach;
    for (; at != order.end() && pieces[*at].from.x <= p.to.x + reach; ++at) {
      const double d = glm::length(pieces[*at].from - p.to);
      if (d < nearest) {
        nearest = d;
        best = *at;
      }
    }
    return best;
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
      i = after(pieces[i]);
    }
    if (i != first) return {};
    curves.push_back(std::move(curve));
  }
  return curves;
}

}  // namespace

Vec2 OutlinePiece::at(double share) const {
  return radius > 0 ? on_circle(centre, radius, angle + share * turn) : from + share * (to - from);
}

Resumable<std::vector<OutlineCurve>> outline_of(std::span<const DiscMove> moves, double radius) {
  KERF_ASSERT(radius > 0);
  const std::vector<OutlinePiece> pieces = co_await pieces_of_outline(moves, radius);
  co_return chain(pieces, radius);
}

}  // namespace kerf
