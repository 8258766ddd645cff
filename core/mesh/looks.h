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

// Looks as functions on the triangles as loaded: UVs and normals by barycentric coordinates, and the
// materials of the file. Immutable, and shared by all copies of a body and the bodies detached from it. A
// face of today evaluates the functions of the loaded face that contains it (Body::loaded_face), so that
// edits of faces need no care of them.
//
// Memory per loaded face, on a smooth mesh without seams: 24 bytes for positions, 16 for a set of UVs, 18 for
// normals. Equal tuples are shared, and so are equal lists of corners.
class Looks {
 public:
  // `sources` are the triangles of the soup by loaded face, empty if they are the same; `turned` tells which
  // loaded faces have the opposite orientation in the mesh. Returns null if the soup has neither looks nor
  // surfaces nor asks for its corners. Appends a warning about values that are not finite. Linear time.
  static std::shared_ptr<const Looks> make(const Soup& soup, std::span<const uint32_t> sources,
                                           const std::vector<bool>& turned,
                                           std::vector<std::string>& warnings);

  size_t uv_sets() const { return uv_sets_.size(); }
  bool v_points_down() const { return v_points_down_; }  // see CornerLooks
  bool has_normals() const { return normals_.corners != nullptr; }
  // Returns true if faces can be located, which surfaces alone do not need.
  bool has_corners() const { return positions_.corners != nullptr; }
  // Return true if a loaded face has these values. False for faces that were not loaded, such as walls.
  bool contains(FaceId loaded) const { return positions_.contains(loaded); }
  bool has_uvs(size_t set, FaceId loaded) const { return uv_sets_[set].contains(loaded); }
  bool has_normal(FaceId loaded) const { return normals_.contains(loaded); }

  // Returns the barycentric coordinates of a point in a loaded face, whose corners have the order of the
  // file. They are exact at its corners, and on its sides depend on the ends of the side only, so that both
  // faces there have the same values. A point off the plane is projected. Precondition: contains(loaded).
  Vec3 barycentrics(FaceId loaded, const Vec3& point) const;
  // Returns the corners of a loaded face in the order of the file. Precondition: contains(loaded).
  Triangle triangle(FaceId loaded) const { return positions_.at(loaded); }
  // Returns true if a part of a loaded face has its orientation in the file. Precondition: contains(loaded).
  bool agrees(FaceId loaded, const Triangle& part) const;

  // Returns the number of a loaded face among the triangles of the soup.
  uint32_t number_in_file(FaceId loaded) const {
    return sources_.empty() ? loaded.index : sources_[loaded.index];
  }

  // A point at which values are evaluated: in a loaded face, or close to one. Vertices that slide onto a
  // smooth rim leave the loaded faces of some of their faces.
  struct Point {
    FaceId face;
    Vec3 weights{0};
    bool is_on_plane = true;  // of `face`
    // Another loaded face whose values hold at the point, unless there is a seam between the two: it contains
    // the point, or the point is on its plane and not on that of `face`.
    FaceId adjacent{};
    Vec3 adjacent_weights{0};
  };
  // Locates a point by its own loaded face. `is_inside` becomes false if it lies outside of the face, so that
  // continue_in() should be called with other loaded faces around it. Precondition: contains(loaded).
  Point locate(FaceId loaded, const Vec3& at, bool& is_inside) const;
  // Continues a point by another loaded face if that is better. Returns true if that face contains the point,
  // which ends the search. Precondition: contains(adjacent).
  bool continue_in(Point& point, FaceId adjacent, const Vec3& at) const;

  // Return the values at a point. The normal has the orientation of the loaded face in the file, and is not
  // normalised. Precondition: the face has the values.
  glm::dvec2 uv(size_t set, const Point& point) const { return value<glm::dvec2>(uv_sets_[set], point); }
  Vec3 normal(const Point& point) const { return value<Vec3>(normals_, point); }

  // Return a number for each loaded face: equal for faces that a chain of faces connects in which neighbours
  // have a corner and its value in common, so that there is no seam between them.
  std::vector<uint32_t> uv_charts(size_t set) const { return charts(uv_sets_[set]); }
  std::vector<uint32_t> normal_charts() const { return charts(normals_); }

  // Returns true if two loaded faces with UVs have different ones at a corner that they share.
  bool has_seam(FaceId a, FaceId b) const;

  // Materials by FaceData::material; null if the file describes none.
  const std::shared_ptr<const SurfaceLibrary>& surfaces() const { return surfaces_; }

  size_t bytes() const;  // without the surfaces

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
  class Builder;

  bool lies_on_plane(FaceId loaded, const Vec3& at) const;
  // Returns true if two loaded faces share corners, and the values of a channel there.
  template <typename T>
  bool continues(const Channel<T>& channel, FaceId a, FaceId b) const;
  template <typename T>
  std::vector<uint32_t> charts(const Channel<T>& channel) const;
  template <typename V, typename T>
  V value(const Channel<T>& channel, const Point& point) const;

  Channel<Vec3> positions_;
  std::vector<Channel<glm::vec2>> uv_sets_;
  Channel<glm::vec3> normals_;
  bool v_points_down_ = false;
  std::shared_ptr<const SurfaceLibrary> surfaces_;
  std::vector<uint32_t> sources_;  // by loaded face, if the soup keeps corners; empty if they are the same
};

}  // namespace kerf
