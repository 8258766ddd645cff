#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/mesh/files/file_frame.h"
#include "core/tree/touched_walk.h"
#include "core/world/world.h"

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

}  // namespace kerf
