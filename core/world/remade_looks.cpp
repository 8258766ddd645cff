#include "core/world/remade_looks.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/assert.h"
#include "core/base/tolerances.h"
#include "core/mesh/looks.h"
#include "core/mesh/measures.h"

namespace kerf {

namespace {

class Transfer {
 public:
  Transfer(const Body& body, const PieceCopy& copy, const Remeshed& remeshed)
      : body_(body), looks_(*body.looks), remeshed_(remeshed) {
    KERF_ASSERT(remeshed.origins.size() == remeshed.triangles.size());
    for (const FaceId origin : remeshed.origins)
      sources_.push_back(body.loaded_source(copy.faces[origin.index]));
    if (!looks_.has_corners()) return;
    for (const Vec3& p : remeshed.positions) near_.push_back(near_points(p));
  }

  std::shared_ptr<const Looks> run() {
    Soup soup;
    soup.positions = remeshed_.positions;
    soup.triangles = remeshed_.triangles;
    soup.surfaces = looks_.surfaces();
    soup.looks.v_points_down = looks_.v_points_down();
    for (const auto& set : remeshed_.uv_sets) soup.looks.uv_sets.push_back(carried(set));
    for (size_t set = soup.looks.uv_sets.size(); set < looks_.uv_sets(); ++set) {
      soup.looks.uv_sets.push_back(channel<glm::vec2>(
          looks_.uv_charts(set), [&](FaceId f) { return looks_.has_uvs(set, f); },
          [&](size_t, const Looks::Point& point) { return glm::vec2(looks_.uv(set, point)); }));
    }
    if (looks_.has_normals()) {
      soup.looks.normals = channel<glm::vec3>(
          looks_.normal_charts(), [&](FaceId f) { return looks_.has_normal(f); },
          [&](size_t t, const Looks::Point& point) { return normal(t, point); });
    }
    if (looks_.has_tangents()) {
      soup.looks.tangents = channel<glm::vec4>(
          looks_.tangent_charts(), [&](FaceId f) { return looks_.has_tangent(f); },
          [&](size_t t, const Looks::Point& point) { return tangent(t, point); });
    }
    for (size_t i = 0; i < looks_.attributes(); ++i) {
      soup.looks.attributes.push_back(
          {looks_.attribute_name(i), looks_.attribute_parts(i),
           channel<glm::vec4>(
               looks_.attribute_charts(i), [&](FaceId f) { return looks_.has_attribute(i, f); },
               [&](size_t, const Looks::Point& point) { return glm::vec4(looks_.attribute(i, point)); })});
    }
    std::vector<std::string> warnings;  // none, because all values are finite
    return Looks::make(soup, {}, std::vector<bool>(soup.triangles.size(), false), warnings);
  }

 private:
  // The nearest points of the surface before and others almost as near, on the other side of a seam.
  std::vector<PointOnFace> near_points(const Vec3& at) const {
    std::vector<PointOnFace> points;
    const auto nearest = body_.tree.nearest_point(body_.mesh, at);
    if (!nearest) return points;
    const double size = std::max({std::abs(at.x), std::abs(at.y), std::abs(at.z)});
    body_.tree.points_within(body_.mesh, at, 2 * std::sqrt(nearest->distance2) + kSideRoundings * size,
                             points);
    return points;
  }

  // Returns a set of UVs that the tool has carried.
  static LookChannel<glm::vec2> carried(const std::vector<FaceUvs>& set) {
    LookChannel<glm::vec2> to;
    for (const FaceUvs& uvs : set) {
      auto& corners = to.corners.emplace_back();
      corners.fill(LookChannel<glm::vec2>::kNone);
      for (size_t i = 0; i < 3 && has_uvs(uvs); ++i) {
        corners[i] = static_cast<uint32_t>(to.values.size());
        to.values.emplace_back(uvs[i]);
      }
    }
    return to;
  }

  // Evaluates a channel at all corners: value(triangle, point).
  template <typename T, typename Has, typename Value>
  LookChannel<T> channel(const std::vector<uint32_t>& charts, const Has& has, const Value& value) {
    LookChannel<T> to;
    for (size_t t = 0; t < sources_.size(); ++t) {
      auto& corners = to.corners.emplace_back();
      corners.fill(LookChannel<T>::kNone);
      if (!sources_[t].valid() || !has(sources_[t])) continue;
      for (size_t i = 0; i < 3; ++i) {
        const uint32_t vertex = remeshed_.triangles[t][i];
        corners[i] = static_cast<uint32_t>(to.values.size());
        const Vec3& at = remeshed_.positions[vertex];
        const T predicted = value(t, {sources_[t], looks_.barycentrics(sources_[t], at)});
        T best = value(t, {sources_[t], looks_.barycentrics(
                                            sources_[t], nearest_point(at, looks_.triangle(sources_[t])))});
        std::optional<double> distance2;
        for (const PointOnFace& near : near_[vertex]) {
          const FaceId source = body_.loaded_source(near.face);
          if (!source.valid() || charts[source.index] != charts[sources_[t].index]) continue;
          if (distance2 && near.distance2 > *distance2) break;
          const T other = value(t, {source, looks_.barycentrics(source, near.point)});
          // A seam within a chart, as on a cylinder, has two values at one point.
          if (!distance2 || glm::distance(other, predicted) < glm::distance(best, predicted)) best = other;
          distance2 = near.distance2;
        }
        to.values.push_back(best);
      }
    }
    return to;
  }

  bool agrees(size_t t, const Looks::Point& point) const {
    const auto& [a, b, c] = remeshed_.triangles[t];
    const auto& at = remeshed_.positions;
    return looks_.agrees(point.face, {at[a], at[b], at[c]});
  }
  // The normal and the sign of the bitangent have the orientation of the new triangle.
  glm::vec3 normal(size_t t, const Looks::Point& point) const {
    const Vec3 n = looks_.normal(point);
    return glm::vec3(agrees(t, point) ? n : -n);
  }
  glm::vec4 tangent(size_t t, const Looks::Point& point) const {
    glm::dvec4 tangent = looks_.tangent(point);
    if (!agrees(t, point)) tangent.w = -tangent.w;
    return glm::vec4(tangent);
  }

  const Body& body_;
  const Looks& looks_;
  const Remeshed& remeshed_;
  std::vector<FaceId> sources_;                 // by triangle, loaded faces
  std::vector<std::vector<PointOnFace>> near_;  // by position
};

}  // namespace

std::shared_ptr<const Looks> remade_looks(const Body& body, const PieceCopy& copy, const Remeshed& remeshed) {
  return body.looks ? Transfer(body, copy, remeshed).run() : nullptr;
}

}  // namespace kerf
