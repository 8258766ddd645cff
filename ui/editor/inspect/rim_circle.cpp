#include "ui/editor/inspect/rim_circle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "core/base/assert.h"
#include "core/base/deterministic_math.h"
#include "core/document/piece_looks.h"
#include "ui/render/bodies/body_picture.h"

namespace kerf {

namespace {

constexpr int kSteps = 20;          // of Gauss-Newton; it converges quadratically near the solution
constexpr double kReachOfRim = 14;  // screen coordinates
constexpr double kSameEdge = 0.5;   // screen coordinates; rims that are equally near share an edge
// Share of the distance from the eye by which a face may be in front of a visible rim, and the rim over the
// section plane.
constexpr double kBeforeRim = 1e-3;

// The symmetric equations of three unknowns: sums of w * a a^T and w * a b.
struct NormalEquations {
  std::array<std::array<double, 3>, 3> left{};
  Vec3 right{0};

  void add(const Vec3& a, double b, double weight) {
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j)
        left[static_cast<size_t>(i)][static_cast<size_t>(j)] += weight * a[i] * a[j];
      right[i] += weight * a[i] * b;
    }
  }
  // Cramer's rule; nullopt if the equations are singular.
  std::optional<Vec3> solution() const {
    const auto row = [&](size_t i) { return Vec3(left[i][0], left[i][1], left[i][2]); };
    const Vec3 a = row(0), b = row(1), c = row(2);
    const double determinant = glm::dot(a, glm::cross(b, c));
    if (!(std::abs(determinant) > 0)) return std::nullopt;
    return (right.x * glm::cross(b, c) + right.y * glm::cross(c, a) + right.z * glm::cross(a, b)) /
           determinant;
  }
};

// Points in the plane of a circle, in units of their mean distance from the origin.
struct PlanePoints {
  std::vector<Vec2> at;
  std::vector<double> weights;
};

// Minimises the squared difference of x^2 + y^2 + a x + b y + c from 0. Returns centre and radius.
std::optional<Vec3> algebraic_circle(const PlanePoints& points) {
  NormalEquations equations;
  for (size_t i = 0; i < points.at.size(); ++i) {
    const Vec2& p = points.at[i];
    equations.add({p.x, p.y, 1}, glm::dot(p, p), points.weights[i]);
  }
  const auto solved = equations.solution();
  if (!solved) return std::nullopt;
  const Vec2 centre = 0.5 * Vec2(*solved);
  const double radius2 = solved->z + glm::dot(centre, centre);
  if (!(radius2 > 0)) return std::nullopt;
  return Vec3(centre, std::sqrt(radius2));
}

// Minimises the squared distances from a circle (centre and radius), beginning with this one.
Vec3 refined(Vec3 circle, const PlanePoints& points) {
  for (int step = 0; step < kSteps; ++step) {
    NormalEquations equations;
    for (size_t i = 0; i < points.at.size(); ++i) {
      const Vec2 from = points.at[i] - Vec2(circle);
      const double length = glm::length(from);
      if (length > 0) equations.add({from / length, 1}, length - circle.z, points.weights[i]);
    }
    const auto change = equations.solution();
    if (!change || !std::isfinite(glm::length(*change))) return circle;
    circle += *change;
    if (glm::length(*change) < 1e-15 * circle.z) return circle;
  }
  return circle;
}

// Follows sides from corner to corner, as long as one begins where the last one ends.
std::vector<std::vector<Vec3>> loops_of(const Mesh& mesh, const std::vector<Mesh::Side>& sides) {
  constexpr uint32_t kNone = ~uint32_t{0};
  std::vector<uint32_t> side_from(mesh.vertex_slots(), kNone);
  for (uint32_t i = 0; i < sides.size(); ++i) side_from[sides[i].from.index] = i;
  std::vector<char> visited(sides.size());
  std::vector<std::vector<Vec3>> loops;
  for (uint32_t first = 0; first < sides.size(); ++first) {
    std::vector<Vec3> loop;
    for (uint32_t at = first; at != kNone && !visited[at]; at = side_from[sides[at].to.index]) {
      visited[at] = 1;
      loop.push_back(mesh.position(sides[at].from));
    }
    if (loop.size() >= 3) loops.push_back(std::move(loop));
  }
  return loops;
}

// Appends the sides of walls on edges that they share with faces that are none.
void append_wall_sides(const Body& body, std::vector<Mesh::Side>& sides) {
  std::vector<Mesh::Side> others;
  for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
    const FaceId face(f);
    if (!body.mesh.is_live(face) || !body.walls.contain(body.mesh, face)) continue;
    const std::array<VertexId, 3> corners = body.mesh.corners(face);
    for (size_t i = 0; i < 3; ++i) {
      others.clear();
      body.mesh.append_edge_sides(face, corners[i], corners[(i + 1) % 3], others);
      const bool ends = std::any_of(others.begin(), others.end(), [&](const Mesh::Side& other) {
        return !body.walls.contain(body.mesh, other.face);
      });
      if (ends) sides.push_back({face, corners[i], corners[(i + 1) % 3]});
    }
  }
}

// Finds the boundaries of the smooth parts of a mesh, which end where the surface turns by more than the
// crease angle, or at edges with one face or more than two.
class SmoothParts {
 public:
  explicit SmoothParts(const Mesh& mesh) : mesh_(mesh), normals_(mesh.face_slots(), Vec3(0)) {
    for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
      if (!mesh.is_live(FaceId(f))) continue;
      const Triangle t = mesh.triangle(FaceId(f));
      const Vec3 area = glm::cross(t[1] - t[0], t[2] - t[0]);
      if (glm::length(area) > 0) normals_[f] = glm::normalize(area);
    }
  }

  // Appends the boundaries, except those that consist of edges with one face. O(faces).
  void append_boundaries(std::vector<std::vector<Vec3>>& loops) {
    std::vector<std::array<bool, 3>> visited(mesh_.face_slots());
    for (uint32_t f = 0; f < mesh_.face_slots(); ++f) {
      if (!mesh_.is_live(FaceId(f))) continue;
      const std::array<VertexId, 3> corners = mesh_.corners(FaceId(f));
      for (size_t i = 0; i < 3; ++i) {
        const Mesh::Side first{FaceId(f), corners[i], corners[(i + 1) % 3]};
        if (visited[f][i] || smooth_neighbour(first)) continue;
        std::vector<Vec3> loop;
        bool is_open = true;
        for (Mesh::Side side = first; !visited[side.face.index][corner_of(side)]; side = next(side)) {
          visited[side.face.index][corner_of(side)] = true;
          loop.push_back(mesh_.position(side.from));
          is_open = is_open && sides_at(side).empty();
        }
        if (!is_open && loop.size() >= 3) loops.push_back(std::move(loop));
      }
    }
  }

 private:
  size_t corner_of(const Mesh::Side& side) const {
    const std::array<VertexId, 3> corners = mesh_.corners(side.face);
    return static_cast<size_t>(std::find(corners.begin(), corners.end(), side.from) - corners.begin());
  }
  const std::vector<Mesh::Side>& sides_at(const Mesh::Side& side) {
    others_.clear();
    mesh_.append_edge_sides(side.face, side.from, side.to, others_);
    return others_;
  }
  // Returns the opposite side of the edge if it belongs to the same part. Symmetric.
  std::optional<Mesh::Side> smooth_neighbour(const Mesh::Side& side) {
    const std::vector<Mesh::Side>& others = sides_at(side);
    if (others.size() != 1) return std::nullopt;
    const Mesh::Side other = others.front();
    const double cosine = glm::dot(normals_[side.face.index], normals_[other.face.index]);
    if (cosine < kCreaseCosine || mesh_.position(other.to) != mesh_.position(side.from)) return std::nullopt;
    return other;
  }
  Mesh::Side following_in_face(const Mesh::Side& side) const {
    const std::array<VertexId, 3> corners = mesh_.corners(side.face);
    const size_t i = corner_of(side);
    return {side.face, corners[(i + 1) % 3], corners[(i + 2) % 3]};
  }
  // Returns the next side of the boundary: turns about the end of the side within its part.
  Mesh::Side next(const Mesh::Side& side) {
    Mesh::Side at = following_in_face(side);
    while (const auto other = smooth_neighbour(at)) at = following_in_face(*other);
    return at;
  }

  const Mesh& mesh_;
  std::vector<Vec3> normals_;  // by slot of a face; 0 without an area
  std::vector<Mesh::Side> others_;
};

// Returns the point of a segment that is nearest to `at`, as a fraction of it.
double nearest_share(Vec2 from, Vec2 to, Vec2 at) {
  const double length2 = glm::dot(to - from, to - from);
  return length2 > 0 ? std::clamp(glm::dot(at - from, to - from) / length2, 0.0, 1.0) : 0;
}

// Returns the deviation of a rim from its circle over the radius; infinite if no circle fits.
double relative_deviation(const std::vector<Vec3>& rim) {
  const auto circle = fit_circle(rim);
  return circle ? circle->deviation / circle->radius : std::numeric_limits<double>::infinity();
}

bool is_visible(const World& world, const ViewState& view, const Vec3& point) {
  const PrimaryViewport viewport(view);
  const auto place = viewport.place_of(point);
  if (!place) return false;
  const Pose ray = viewport.ray(*place);
  const double distance = glm::dot(point - ray.origin, ray.direction);
  const SectionPlane* section = shown_section(view.look);
  if (section != nullptr && section->height_of(point) > kBeforeRim * distance) return false;
  const auto hit = pick(world, view.look, ray);
  return !hit || hit->length > (1 - kBeforeRim) * distance;
}

}  // namespace

std::optional<FittedCircle> fit_circle(std::span<const Vec3> polygon) {
  if (polygon.size() < 3) return std::nullopt;
  const size_t count = polygon.size();
  Vec3 middle(0), area(0);
  double around = 0;
  for (size_t i = 0; i < count; ++i) {
    const Vec3 &from = polygon[i], &to = polygon[(i + 1) % count];
    const double length = glm::length(to - from);
    around += length;
    middle += 0.5 * length * ((from - polygon[0]) + (to - polygon[0]));
    area += 0.5 * glm::cross(from - polygon[0], to - polygon[0]);
  }
  if (!(around > 0) || !(glm::length(area) > 0)) return std::nullopt;
  middle = polygon[0] + middle / around;
  const Vec3 normal = glm::normalize(area);
  const Vec3 abs = glm::abs(normal);
  const Vec3 helper = abs.x <= abs.y && abs.x <= abs.z ? Vec3(1, 0, 0)
                      : abs.y <= abs.z                 ? Vec3(0, 1, 0)
                                                       : Vec3(0, 0, 1);
  const Vec3 u = glm::normalize(glm::cross(normal, helper)), v = glm::cross(normal, u);
  const double unit = around / (2 * kPi);  // the radius of a circle of this length
  PlanePoints points;
  for (size_t i = 0; i < count; ++i) {
    const Vec3 p = (polygon[i] - middle) / unit;
    points.at.emplace_back(glm::dot(u, p), glm::dot(v, p));
    points.weights.push_back((glm::length(polygon[(i + 1) % count] - polygon[i]) +
                              glm::length(polygon[i] - polygon[(i + count - 1) % count])) /
                             around);
  }
  const auto begin = algebraic_circle(points);
  if (!begin) return std::nullopt;
  const Vec3 circle = refined(*begin, points);
  FittedCircle fitted{middle + unit * (circle.x * u + circle.y * v), normal, unit * circle.z};
  for (const Vec3& p : polygon) {
    const double height = glm::dot(normal, p - fitted.centre);
    const double out = glm::length(p - fitted.centre - height * normal) - fitted.radius;
    fitted.deviation = std::max(fitted.deviation, std::sqrt(height * height + out * out));
  }
  return fitted;
}

std::vector<std::vector<Vec3>> rims_of(const Body& body) {
  std::vector<Mesh::Side> sides;
  body.mesh.append_open_sides(sides);
  std::vector<std::vector<Vec3>> rims = loops_of(body.mesh, sides);
  if (body.solid) {
    sides.clear();
    append_wall_sides(body, sides);
    for (std::vector<Vec3>& rim : loops_of(body.mesh, sides)) rims.push_back(std::move(rim));
  }
  SmoothParts(body.mesh).append_boundaries(rims);
  return rims;
}

std::optional<std::vector<Vec3>> rim_at(const World& world, const ViewState& view, Vec2 place) {
  const PrimaryViewport viewport(view);
  std::vector<std::vector<Vec3>> rims;
  struct Near {
    double distance;
    size_t rim;
    Vec3 point;
  };
  std::vector<Near> near;
  for (const BodyId id : world.ids()) {
    const Body& body = world.body(id);
    if (body.hidden) continue;
    for (std::vector<Vec3>& rim : rims_of(body)) {
      for (Vec3& p : rim) p = body.placement.to_world(p);
      for (size_t i = 0; i < rim.size(); ++i) {
        const Vec3 &from = rim[i], &to = rim[(i + 1) % rim.size()];
        const auto seen_from = viewport.place_of(from), seen_to = viewport.place_of(to);
        if (!seen_from || !seen_to) continue;
        const double share = nearest_share(*seen_from, *seen_to, place);
        const double distance = glm::length(*seen_from + share * (*seen_to - *seen_from) - place);
        if (distance < kReachOfRim) near.push_back({distance, rims.size(), from + share * (to - from)});
      }
      rims.push_back(std::move(rim));
    }
  }
  std::stable_sort(near.begin(), near.end(),
                   [](const Near& a, const Near& b) { return a.distance < b.distance; });
  const auto nearest =
      std::find_if(near.begin(), near.end(), [&](const Near& n) { return is_visible(world, view, n.point); });
  if (nearest == near.end()) return std::nullopt;
  size_t roundest = nearest->rim;
  for (auto other = nearest; other != near.end() && other->distance <= nearest->distance + kSameEdge;
       ++other) {
    if (relative_deviation(rims[other->rim]) < relative_deviation(rims[roundest])) roundest = other->rim;
  }
  return rims[roundest];
}

}  // namespace kerf
