#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/assert.h"
#include "core/cut/knife_internal.h"
#include "core/mesh/measures.h"

namespace kerf {

namespace {

constexpr int kCellsAlong = 48;     // of the grid of places for pegs, along the longer side of a section
constexpr double kPegMargin = 0.5;  // material left around a peg and its hole, in radii of the peg

// Places for pegs in the section that sides bound, in a plane.
class PegPlaces {
 public:
  PegPlaces(const Mesh& mesh, std::span<const Mesh::Side> sides, const WallPlane& plane) : plane_(plane) {
    const Vec3 size = glm::abs(plane.normal);
    const Vec3 least = size.x <= size.y && size.x <= size.z ? Vec3(1, 0, 0)
                       : size.y <= size.z                   ? Vec3(0, 1, 0)
                                                            : Vec3(0, 0, 1);
    u_ = glm::normalize(glm::cross(plane.normal, least));
    v_ = glm::cross(plane.normal, u_);
    for (const Mesh::Side& side : sides) {
      ends_.push_back(flat(mesh.position(side.from)));
      ends_.push_back(flat(mesh.position(side.to)));
    }
  }

  // Returns the centres of cells of a grid at least `apart` from the border of the section, with the
  // distance.
  struct Place {
    Vec2 at{0};
    double distance = 0;
  };
  std::vector<Place> places(double apart) const {
    std::vector<Place> found;
    if (ends_.empty()) return found;
    Vec2 low = ends_.front(), high = low;
    for (const Vec2& p : ends_) {
      low = glm::min(low, p);
      high = glm::max(high, p);
    }
    const double step = std::max(high.x - low.x, high.y - low.y) / kCellsAlong;
    const Vec2 far = glm::max(glm::abs(low), glm::abs(high));
    const double farthest = std::max(far.x, far.y);
    if (!(farthest + step / 2 > farthest)) return found;  // doubles are too coarse there for the grid
    for (double y = low.y + step / 2; y < high.y; y += step) {
      for (double x = low.x + step / 2; x < high.x; x += step) {
        const double distance = depth_of({x, y});
        if (distance >= apart) found.push_back({{x, y}, distance});
      }
    }
    return found;
  }

  Vec3 point(Vec2 p) const { return plane_.distance * plane_.normal + p.x * u_ + p.y * v_; }

 private:
  Vec2 flat(const Vec3& p) const { return {glm::dot(p, u_), glm::dot(p, v_)}; }

  // Returns the distance of a point from the border; -1 outside of the section, by the even-odd rule.
  double depth_of(Vec2 p) const {
    double distance2 = std::numeric_limits<double>::infinity();
    bool inside = false;
    for (size_t i = 0; i < ends_.size(); i += 2) {
      const Vec2 a = ends_[i], b = ends_[i + 1];
      if ((a.y > p.y) != (b.y > p.y)) {
        const double side = cross2(b - a, p - a);
        if ((side > 0) == (b.y > a.y)) inside = !inside;
      }
      const Vec3 apart = nearest_on_segment(Vec3(p, 0), Vec3(a, 0), Vec3(b, 0)) - Vec3(p, 0);
      distance2 = std::min(distance2, glm::dot(apart, apart));
    }
    return inside ? std::sqrt(distance2) : -1;
  }

  const WallPlane& plane_;
  Vec3 u_{0}, v_{0};        // axes of the plane
  std::vector<Vec2> ends_;  // of the sides, in pairs
};

}  // namespace

std::vector<Vec3> peg_centres(const Mesh& mesh, std::span<const Mesh::Side> sides, const WallPlane& plane,
                              const Pegs& pegs, const std::function<bool(const Vec3&, double)>& has_room) {
  const double radius = pegs.diameter / 2, reach = radius + pegs.tolerance + kPegMargin * radius;
  KERF_ASSERT(radius > 0 && is_unit(plane.normal));
  const PegPlaces section(mesh, sides, plane);
  const std::vector<PegPlaces::Place> all = section.places(reach);
  std::vector<PegPlaces::Place> places = all;
  std::vector<Vec3> centres;
  while (static_cast<int>(centres.size()) < pegs.count && !places.empty()) {
    // The place farthest from the border is the first; then the one farthest from the pegs so far.
    const auto best = std::ranges::max_element(places, {}, &PegPlaces::Place::distance);
    const PegPlaces::Place place = *best;
    places.erase(best);
    const Vec3 centre = section.point(place.at);
    if (!has_room(centre, reach)) continue;
    const bool is_first = centres.empty();
    centres.push_back(centre);
    for (PegPlaces::Place& other : places) {
      const double apart = glm::length(other.at - place.at);
      other.distance = is_first ? apart : std::min(other.distance, apart);
    }
    std::erase_if(places, [&](const PegPlaces::Place& p) { return p.distance < 2 * reach; });
  }
  if (centres.empty() || static_cast<int>(centres.size()) == pegs.count) return centres;
  // More pegs may fit in rows, because a peg in the middle takes the room of several around it.
  std::vector<Vec3> in_rows;
  std::vector<Vec2> taken;
  for (const PegPlaces::Place& place : all) {
    if (static_cast<int>(in_rows.size()) == pegs.count) break;
    const bool is_free = std::ranges::none_of(taken, [&](const Vec2& other) {
      const Vec2 apart = glm::abs(place.at - other);
      return std::max(apart.x, apart.y) < 2 * reach;
    });
    const Vec3 centre = section.point(place.at);
    if (!is_free || !has_room(centre, reach)) continue;
    in_rows.push_back(centre);
    taken.push_back(place.at);
  }
  return in_rows.size() > centres.size() ? in_rows : centres;
}

}  // namespace kerf
