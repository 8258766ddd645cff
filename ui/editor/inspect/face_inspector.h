#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/base/geometry.h"
#include "core/mesh/files/mesh_format.h"
#include "core/tree/queries.h"
#include "core/world/world.h"
#include "ui/editor/shared/viewport.h"

namespace kerf {

// Properties of one face. Edge i runs from corner i to the next corner.
struct FaceFacts {
  FaceId face;
  FaceId loaded;     // face of the file that contains it
  int halvings = 0;  // of the area of the loaded face
  uint32_t piece = 0;
  double area = 0;                                // m^2
  std::array<double, 3> edges{};                  // m
  std::array<double, 3> angles{};                 // degrees, at the corners; 0 at an edge without length
  TreeSlot slot;                                  // in the tree
  std::array<std::vector<FaceId>, 3> neighbours;  // other faces on each edge: none on a border
  double temperature = kAmbient;                  // K
  double hottest = kAmbient;                      // K, recorded maximum
};

// Computes the properties of a face. Precondition: the face is live. O(faces on its edges).
FaceFacts face_facts(const Body& body, FaceId face);

// Formats the properties as lines of text, with the name of the piece and lengths in file units.
std::vector<std::string> lines_of(const FaceFacts& facts, const std::string& piece, FileUnit unit);

// The angle at the middle one of three points, and the radius of the circle through them.
struct Corner {
  double degrees = 0;            // 0 to 180
  std::optional<double> radius;  // m; nullopt if the points lie on a line
};
Corner measure_corner(const Vec3& from, const Vec3& at, const Vec3& to);

// Records the temperature over world time of the point last clicked with the inspect tool. The curve
// continues while that tool or the temperature view is active; another click or an undo of time restarts it.
class HeatProbe {
 public:
  struct Sample {
    double seconds = 0;  // of world time
    double temperature = kAmbient;
  };

  // Called once per frame, while the world does not change, with the last clicked point; nullopt ends the
  // curve, unless another tool is used in the temperature view. `inspects`: the inspect tool is active.
  void follow(const World& world, const ViewState& view, const std::optional<Vec3>& clicked, bool inspects);

  const std::vector<Sample>& samples() const { return samples_; }
  const std::optional<Vec3>& at() const { return at_; }

  static constexpr size_t kMaxSamples = 2000;

 private:
  void add(const Sample& sample);

  std::optional<Vec3> at_;
  Pose ray_;  // meets the point from its front
  std::vector<Sample> samples_;
};

// Draws the curve in the lower right corner of the viewport, once it has two samples.
void draw_heat_probe(const HeatProbe& probe, const Area& picture);

}  // namespace kerf
