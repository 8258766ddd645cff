#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/mesh/files/mesh_format.h"
#include "core/tree/touched_walk.h"
#include "core/world/world.h"
#include "ui/editor/shared/viewport.h"

namespace kerf {

// What there is to say about one face. Edge i goes from corner i to the next one.
struct FaceFacts {
  FaceId face;
  FaceId loaded;     // the face of the file that it is a part of
  int halvings = 0;  // how often the area of the loaded face was halved
  uint32_t piece = 0;
  double area = 0;                                // m^2
  std::array<double, 3> edges{};                  // m
  std::array<double, 3> angles{};                 // degrees, at the corners; 0 where an edge has no length
  TreeSlot slot;                                  // in the tree
  std::array<std::vector<FaceId>, 3> neighbours;  // the other faces on each edge: none on a border
  double temperature = kAmbient;                  // K
  double hottest = kAmbient;                      // K, that it ever was, as far as it was noted
};

// Precondition: the face is live. Constant time but for the degrees of the rings around it.
FaceFacts face_facts(const Body& body, FaceId face);

// The facts as lines for people, with lengths in the numbers of the file.
std::vector<std::string> lines_of(const FaceFacts& facts, const Body& body, FileUnit unit);

// The temperature of a point over the time of the world: the one that was clicked last with the tool that
// inspects. The curve goes on while that tool or the temperature view is chosen, and begins anew at another
// click, or where time went back by undo.
class HeatProbe {
 public:
  struct Sample {
    double seconds = 0;  // since the world began
    double temperature = kAmbient;
  };

  // To be called once a frame, at a time at which the world does not change, with the point that was clicked
  // last. `inspects`: the tool is in hand.
  void follow(const World& world, const ViewState& view, const std::optional<Vec3>& clicked, bool inspects);

  const std::vector<Sample>& samples() const { return samples_; }
  const std::optional<Vec3>& at() const { return at_; }

  static constexpr size_t kMaxSamples = 2000;

 private:
  void add(const Sample& sample);

  std::optional<Vec3> at_;
  Pose ray_;  // meets the point from in front of it
  std::vector<Sample> samples_;
};

// Draws the curve in the lower right corner of the picture, once it has two samples.
void draw_heat_probe(const HeatProbe& probe, const Area& picture);

}  // namespace kerf
