#include "core/document/piece_looks.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <utility>

#include "core/mesh/face_batches.h"
#include "core/mesh/files/encode.h"
#include "core/mesh/looks.h"
#include "core/mesh/weld.h"

namespace kerf {

namespace {

Vec3 unit_normal_of(const Triangle& t) { return unit_normal(t[0], t[1], t[2]); }

// The weight of a face in the normal at its corner i, exact on a sphere (N. Max: Weights for computing vertex
// normals from facet normals, 1999). Needs no function of the C library whose last bits differ.
double corner_weight(const Triangle& t, size_t i) {
  const Vec3 u = t[(i + 1) % 3] - t[i], w = t[(i + 2) % 3] - t[i];
  const double lengths = glm::dot(u, u) * glm::dot(w, w);
  return lengths > 0 ? glm::length(glm::cross(u, w)) / lengths : 0;
}

// UVs in metres in the plane of a face, the same for all faces of a plane. They do not mirror an image.
std::array<glm::vec2, 3> plane_uvs(const Triangle& t, bool v_points_down) {
  const Vec3 n = unit_normal_of(t);
  const Vec3 size(std::abs(n.x), std::abs(n.y), std::abs(n.z));
  const int flattest = size.y <= size.x && size.y <= size.z ? 1 : size.x <= size.z ? 0 : 2;
  Vec3 axis(0);
  axis[flattest] = 1;
  const Vec3 across = glm::cross(axis, n);
  const double length = glm::length(across);
  if (!(length > 0)) return {glm::vec2(0), glm::vec2(0), glm::vec2(0)};
  const Vec3 u = across / length, v = glm::cross(n, u);
  std::array<glm::vec2, 3> uvs;
  for (size_t i = 0; i < 3; ++i) {
    const double up = glm::dot(t[i], v);
    uvs[i] = glm::vec2(glm::dvec2(glm::dot(t[i], u), v_points_down ? 1 - up : up));
  }
  return uvs;
}

class Evaluation {
 public:
  Evaluation(const Body& body, std::span<const FaceId> faces, LookNormals normals)
      : body_(body),
        looks_(*body.looks),
        faces_(faces),
        normals_(normals),
        wants_normals_(looks_.has_normals() || (normals == LookNormals::kAll && looks_.has_corners())) {}

  CornerLooks run() {
    out_.uv_sets.resize(looks_.uv_sets());
    out_.v_points_down = looks_.v_points_down();
    for (auto& set : out_.uv_sets) set.corners.reserve(faces_.size());
    for (size_t i = 0; i < looks_.attributes() && wants_attributes(); ++i)
      out_.attributes.push_back({looks_.attribute_name(i), looks_.attribute_parts(i), {}});
    for_each_corners(body_.mesh, faces_, [&](FaceId f, const std::array<VertexId, 3>& corners) {
      Triangle t;
      for (size_t i = 0; i < 3; ++i) t[i] = body_.mesh.position(corners[i]);
      add_face(f, corners, t);
    });
    if (bare_ > 0 && wants_normals_ && normals_ != LookNormals::kLoaded) smooth_bare_faces();
    return std::move(out_);
  }

 private:
  void add_face(FaceId f, const std::array<VertexId, 3>& corners, const Triangle& t) {
    const FaceId source = body_.loaded_source(f);
    const bool known = source.valid() && looks_.contains(source);
    std::array<Looks::Point, 3> points;
    for (size_t i = 0; i < 3 && known; ++i) points[i] = locate(source, corners[i], t[i]);
    const bool is_wall = body_.walls.contain(body_.mesh, f);
    for (size_t set = 0; set < out_.uv_sets.size(); ++set) {
      if (known && looks_.has_uvs(set, source)) {
        add(out_.uv_sets[set], {glm::vec2(looks_.uv(set, points[0])), glm::vec2(looks_.uv(set, points[1])),
                                glm::vec2(looks_.uv(set, points[2]))});
      } else if (is_wall) {
        add(out_.uv_sets[set], plane_uvs(t, out_.v_points_down));
      } else {
        out_.uv_sets[set].corners.push_back({kNone, kNone, kNone});
      }
    }
    if (wants_attributes()) add_attributes(source, known, t, points);
    if (!wants_normals_) return;
    triangles_.push_back(t);
    if (!known || !looks_.has_normal(source)) {
      out_.normals.corners.push_back({kNone, kNone, kNone});
      ++bare_;
      return;
    }
    const double sign = looks_.agrees(source, t) ? 1 : -1;
    std::array<glm::vec3, 3> normals;
    for (size_t i = 0; i < 3; ++i) {
      const Vec3 n = sign * looks_.normal(points[i]);
      const double length = glm::length(n);
      normals[i] = in_axes(length > 0 ? n / length : unit_normal_of(t));
    }
    add(out_.normals, normals);
  }

  bool wants_attributes() const { return normals_ != LookNormals::kLoaded; }

  // Adds the tangents and custom attributes of a face.
  void add_attributes(FaceId source, bool known, const Triangle& t,
                      const std::array<Looks::Point, 3>& points) {
    constexpr std::array<uint32_t, 3> kNoCorners{kNone, kNone, kNone};
    for (size_t i = 0; i < out_.attributes.size(); ++i) {
      LookChannel<glm::vec4>& channel = out_.attributes[i].channel;
      if (known && looks_.has_attribute(i, source)) {
        add(channel, {glm::vec4(looks_.attribute(i, points[0])), glm::vec4(looks_.attribute(i, points[1])),
                      glm::vec4(looks_.attribute(i, points[2]))});
      } else {
        channel.corners.push_back(kNoCorners);
      }
    }
    if (!looks_.has_tangents()) return;
    if (!known || !looks_.has_tangent(source)) {
      out_.tangents.corners.push_back(kNoCorners);
      return;
    }
    const double sign = looks_.agrees(source, t) ? 1 : -1;
    std::array<glm::vec4, 3> tangents;
    for (size_t i = 0; i < 3; ++i) {
      const glm::dvec4 own = looks_.tangent(points[i]);
      const double length = glm::length(Vec3(own));
      tangents[i] = {in_axes(length > 0 ? Vec3(own) / length : Vec3(own)), static_cast<float>(sign * own.w)};
    }
    add(out_.tangents, tangents);
  }

  // Locates a corner of a face. If it slid out of the loaded face, the loaded faces around it continue that:
  // of the faces at the corner, then of those at their corners.
  Looks::Point locate(FaceId source, VertexId corner, const Vec3& at) {
    bool is_inside = false;
    Looks::Point point = looks_.locate(source, at, is_inside);
    if (is_inside) return point;
    body_.mesh.star(corner, star_);
    const std::vector<FaceId> around = star_.faces;
    if (continue_over(around, point, at) || point.adjacent.valid()) return point;
    for (const FaceId f : around) {
      for (const VertexId v : body_.mesh.corners(f)) {
        if (v == corner) continue;
        body_.mesh.star(v, star_);
        if (continue_over(star_.faces, point, at)) return point;
      }
    }
    return point;
  }
  bool continue_over(std::span<const FaceId> faces, Looks::Point& point, const Vec3& at) const {
    return std::any_of(faces.begin(), faces.end(), [&](FaceId f) {
      const FaceId source = body_.loaded_source(f);
      return source.valid() && looks_.contains(source) && looks_.continue_in(point, source, at);
    });
  }

  glm::vec3 in_axes(const Vec3& n) const {
    const bool turns =
        normals_ != LookNormals::kLoaded && body_.placement.orientation != glm::dquat(1, 0, 0, 0);
    const Vec3 turned = turns ? body_.placement.orientation * n : n;
    return glm::vec3(turned == Vec3(0) ? Vec3(0, 1, 0) : turned);
  }

  // Neighbouring faces often repeat the values of the last few corners.
  template <typename T>
  static void add(LookChannel<T>& to, const std::array<T, 3>& values) {
    constexpr size_t kRecent = 8;
    auto& corners = to.corners.emplace_back();
    for (size_t i = 0; i < 3; ++i) {
      const size_t first = to.values.size() - std::min(to.values.size(), kRecent);
      const auto at =
          std::find(to.values.begin() + static_cast<std::ptrdiff_t>(first), to.values.end(), values[i]);
      corners[i] = static_cast<uint32_t>(at - to.values.begin());
      if (at == to.values.end()) to.values.push_back(values[i]);
    }
  }

  // Gives the faces without normals the weighted mean of the planes around each corner that deviate by
  // less than the crease angle. Walls and other faces do not mix, so that the rim stays sharp.
  void smooth_bare_faces() {
    std::vector<uint32_t> bare;
    std::vector<Vec3> at;
    for (uint32_t i = 0; i < triangles_.size(); ++i) {
      if (out_.normals.corners[i][0] != kNone) continue;
      bare.push_back(i);
      at.insert(at.end(), triangles_[i].begin(), triangles_[i].end());
    }
    const std::vector<uint32_t> first = weld_positions(at);
    std::vector<uint32_t> begin(at.size() + 1, 0), sides(at.size());
    for (const uint32_t p : first) ++begin[p + 1];
    for (size_t p = 1; p < begin.size(); ++p) begin[p] += begin[p - 1];
    std::vector<uint32_t> next(begin.begin(), begin.end() - 1);
    for (uint32_t s = 0; s < at.size(); ++s) sides[next[first[s]]++] = s;
    std::vector<Vec3> planes;
    for (const uint32_t i : bare) planes.push_back(unit_normal_of(triangles_[i]));
    constexpr uint32_t kMaxFan = 512;  // faces at larger ones are flat
    for (uint32_t b = 0; b < bare.size(); ++b) {
      for (uint32_t i = 0; i < 3; ++i) {
        const uint32_t p = first[3 * b + i];
        Vec3 sum(0);
        for (uint32_t k = begin[p]; k < begin[p + 1] && begin[p + 1] - begin[p] <= kMaxFan; ++k) {
          const uint32_t other = sides[k] / 3;
          if (glm::dot(planes[b], planes[other]) >= kCreaseCosine && is_wall(bare[b]) == is_wall(bare[other]))
            sum += corner_weight(triangles_[bare[other]], sides[k] % 3) * planes[other];
        }
        const double length = glm::length(sum);
        out_.normals.corners[bare[b]][i] = static_cast<uint32_t>(out_.normals.values.size());
        out_.normals.values.push_back(in_axes(length > 0 ? sum / length : planes[b]));
      }
    }
  }

  bool is_wall(uint32_t i) const { return body_.walls.contain(body_.mesh, faces_[i]); }

  static constexpr uint32_t kNone = LookChannel<glm::vec2>::kNone;

  const Body& body_;
  const Looks& looks_;
  std::span<const FaceId> faces_;
  LookNormals normals_;
  bool wants_normals_;
  CornerLooks out_;
  std::vector<Triangle> triangles_;  // of the faces, if normals are wanted
  size_t bare_ = 0;                  // faces without normals
  Mesh::Star star_;                  // scratch
};

}  // namespace

CornerLooks looks_of(const Body& body, std::span<const FaceId> faces, LookNormals normals) {
  if (!body.looks || faces.empty()) return {};
  return Evaluation(body, faces, normals).run();
}

std::vector<FaceSource> sources_of(const Body& body, std::span<const FaceId> faces) {
  std::vector<FaceSource> sources;
  sources.reserve(faces.size());
  for_each_corners(body.mesh, faces, [&](FaceId f, const std::array<VertexId, 3>& corners) {
    FaceSource& source = sources.emplace_back();
    const FaceId loaded = body.loaded_source(f);
    if (!loaded.valid() || !body.looks || !body.looks->contains(loaded)) return;
    source.face = body.looks->number_in_file(loaded);
    for (size_t i = 0; i < 3; ++i)
      source.barycentrics[i] = body.looks->barycentrics(loaded, body.mesh.position(corners[i]));
  });
  return sources;
}

std::string part_name_of(const Body& body, std::span<const MeshPart> parts, std::span<const FaceId> faces) {
  if (parts.empty()) return {};
  // The innermost part of each loaded face that is in use, found once.
  std::map<uint32_t, double> areas;  // by loaded face
  for_each_corners(body.mesh, faces, [&](FaceId f, const std::array<VertexId, 3>& corners) {
    const FaceId loaded = body.loaded_source(f);
    if (!loaded.valid()) return;
    areas[loaded.index] += triangle_area(
        {body.mesh.position(corners[0]), body.mesh.position(corners[1]), body.mesh.position(corners[2])});
  });
  double best = -1;
  size_t size = 0;
  std::string name;
  for (const MeshPart& part : parts) {
    double area = 0;
    for (auto at = areas.lower_bound(part.first); at != areas.end() && at->first < part.last; ++at)
      area += at->second;
    const size_t faces_of_part = part.last - part.first;
    const bool better = area > best || (area == best && faces_of_part < size);
    if (part.name.empty() || area == 0 || !better) continue;
    best = area;
    size = faces_of_part;
    name = part.name;
  }
  return name;
}

}  // namespace kerf
