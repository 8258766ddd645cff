#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/ids.h"
#include "core/mesh/files/soup.h"
#include "core/mesh/mesh.h"

namespace kerf {

// The looks of a loaded mesh, i.e. its UVs, normals, tangents, custom attributes and materials. All but the
// materials are functions on the loaded triangles, evaluated by barycentric coordinates. A current face
// evaluates those of the loaded face that contains it (Body::loaded_face), so edits of faces need not update
// them. Immutable; shared by all copies of a body and the bodies detached from it.
//
// Memory per loaded face, on a smooth mesh without seams: 24 bytes for positions, 16 for a set of UVs, 18 for
// normals, 20 for tangents or a custom attribute. Equal tuples are shared, and so are equal lists of corners.
class Looks {
 public:
  // Creates the looks of a soup. `sources`: by loaded face, the index of its triangle in the soup; empty if
  // both orders are equal. `turned`: by loaded face, whether the mesh reverses its orientation. Returns null
  // if the soup has neither looks nor surfaces and does not keep its corners (see Soup::keeps_corners).
  // Appends a warning about values that are not finite. Linear time.
  static std::shared_ptr<const Looks> make(const Soup& soup, std::span<const uint32_t> sources,
                                           const std::vector<bool>& turned,
                                           std::vector<std::string>& warnings);

  size_t uv_sets() const { return uv_sets_.size(); }
  bool v_points_down() const { return v_points_down_; }  // see CornerLooks
  bool has_normals() const { return normals_.corners != nullptr; }
  bool has_tangents() const { return tangents_.corners != nullptr; }
  size_t attributes() const { return attributes_.size(); }
  const std::string& attribute_name(size_t attribute) const { return attributes_[attribute].name; }
  uint8_t attribute_parts(size_t attribute) const { return attributes_[attribute].parts; }
  // Returns true if points can be located in loaded faces; looks of surfaces alone store no corners.
  bool has_corners() const { return positions_.corners != nullptr; }
  // Return true if a loaded face has corners, UVs or a normal; false for faces that were not loaded, such as
  // walls.
  bool contains(FaceId loaded) const { return positions_.contains(loaded); }
  bool has_uvs(size_t set, FaceId loaded) const { return uv_sets_[set].contains(loaded); }
  bool has_normal(FaceId loaded) const { return normals_.contains(loaded); }
  bool has_tangent(FaceId loaded) const { return tangents_.contains(loaded); }
  bool has_attribute(size_t attribute, FaceId loaded) const {
    return attributes_[attribute].channel.contains(loaded);
  }

  // Returns the barycentric coordinates of a point in a loaded face, with the corners in the order of the
  // file. They are exact at the corners; on a side they depend only on its two ends, so that both adjacent
  // faces have the same values there. A point off the plane is projected onto it. Precondition:
  // contains(loaded).
  Vec3 barycentrics(FaceId loaded, const Vec3& point) const;
  // Returns the corners of a loaded face in the order of the file. Precondition: contains(loaded).
  Triangle triangle(FaceId loaded) const { return positions_.at(loaded); }
  // Returns true if a part of a loaded face has the orientation of that face in the file. Precondition:
  // contains(loaded).
  bool agrees(FaceId loaded, const Triangle& part) const;

  // Returns the index of the soup's triangle from which a loaded face was made.
  uint32_t number_in_file(FaceId loaded) const {
    return sources_.empty() ? loaded.index : sources_[loaded.index];
  }

  // A point at which values are evaluated, in or close to a loaded face. It may lie outside, because a vertex
  // moved onto a smooth rim can leave the loaded faces that contain its adjacent faces.
  struct Point {
    FaceId face;
    Vec3 weights{0};
    bool is_on_plane = true;  // of `face`
    // Another loaded face whose values apply to the point unless a seam separates it from `face`: it contains
    // the point, or its plane does and that of `face` does not.
    FaceId adjacent{};
    Vec3 adjacent_weights{0};
  };
  // Locates a point in a loaded face. `is_inside` becomes false if the point lies outside that face; call
  // continue_in() with the adjacent loaded faces then. Precondition: contains(loaded).
  Point locate(FaceId loaded, const Vec3& at, bool& is_inside) const;
  // Sets Point::adjacent to another loaded face if it suits the point better. Returns true if that face
  // contains the point, which ends the search. Precondition: contains(adjacent).
  bool continue_in(Point& point, FaceId adjacent, const Vec3& at) const;

  // Return the values at a point. The normal has the orientation of the loaded face in the file; normal and
  // tangent are not normalised. The sign of the bitangent is 1 or -1, for that orientation. Precondition: the
  // loaded face has the values.
  glm::dvec2 uv(size_t set, const Point& point) const { return value<glm::dvec2>(uv_sets_[set], point); }
  Vec3 normal(const Point& point) const { return value<Vec3>(normals_, point); }
  glm::dvec4 tangent(const Point& point) const {
    const auto t = value<glm::dvec4>(tangents_, point);
    return {Vec3(t), t.w < 0 ? -1 : 1};
  }
  glm::dvec4 attribute(size_t attribute, const Point& point) const {
    return value<glm::dvec4>(attributes_[attribute].channel, point);
  }

  // Return a chart number per loaded face. Two faces are in one chart if they are connected by a chain of
  // faces in which any two consecutive ones share a corner and its value, i.e. no seam separates them.
  std::vector<uint32_t> uv_charts(size_t set) const { return charts(uv_sets_[set]); }
  std::vector<uint32_t> normal_charts() const { return charts(normals_); }
  std::vector<uint32_t> tangent_charts() const { return charts(tangents_); }
  std::vector<uint32_t> attribute_charts(size_t attribute) const {
    return charts(attributes_[attribute].channel);
  }

  // Returns true if two loaded faces with UVs share a corner at which their UVs differ.
  bool has_seam(FaceId a, FaceId b) const;

  // Returns a hash of all values, materials and images, equal for equal files on every machine. O(1).
  uint64_t hash() const { return hash_; }
  // Materials by FaceData::material; null if the file describes none.
  const std::shared_ptr<const SurfaceLibrary>& surfaces() const { return surfaces_; }

  size_t bytes() const;  // excluding the surfaces

 private:
  using Corners = std::vector<std::array<uint32_t, 3>>;

  template <typename T>
  struct Channel {
    std::vector<T> values;
    std::shared_ptr<const Corners> corners;  // by loaded face; null if no face has values

    bool contains(FaceId loaded) const {
      return corners && loaded.index < corners->size() &&
             (*corners)[loaded.index][0] != LookChannel<T>::kNone;
    }
    std::array<T, 3> at(FaceId loaded) const {
      const auto& [a, b, c] = (*corners)[loaded.index];
      return {values[a], values[b], values[c]};
    }
  };
  struct Attribute {
    std::string name;
    uint8_t parts = 1;
    Channel<glm::vec4> channel;
  };
  class Builder;

  bool lies_on_plane(FaceId loaded, const Vec3& at) const;
  // Returns true if two loaded faces share corners and the values of a channel at these.
  template <typename T>
  bool continues(const Channel<T>& channel, FaceId a, FaceId b) const;
  template <typename T>
  std::vector<uint32_t> charts(const Channel<T>& channel) const;
  template <typename V, typename T>
  V value(const Channel<T>& channel, const Point& point) const;

  Channel<Vec3> positions_;
  std::vector<Channel<glm::vec2>> uv_sets_;
  Channel<glm::vec3> normals_;
  Channel<glm::vec4> tangents_;
  std::vector<Attribute> attributes_;
  bool v_points_down_ = false;
  uint64_t hash_ = 0;
  std::shared_ptr<const SurfaceLibrary> surfaces_;
  std::vector<uint32_t> sources_;  // by loaded face, if the soup keeps corners; empty if they are the same
};

}  // namespace kerf
