#pragma once

#include <map>
#include <vector>

#include "core/world/world.h"

namespace kerf {

// The faces that carry the joints of a world, as they were loaded.
class JointFaces {
 public:
  JointFaces() = default;
  explicit JointFaces(const Joints& joints);

  // Whether a live face of a body carries a joint, by itself or as a part of a loaded face that does.
  // O(face slots).
  bool any_in(const Body& body) const;
  // Whether one of these faces of a body, which may be dead, does.
  bool any_of(const Body& body, const std::vector<FaceId>& faces) const;

 private:
  const std::vector<bool>* of(const Body& body) const;
  static bool carries(const std::vector<bool>& carriers, const Body& body, FaceId f);

  std::map<BodyId, std::vector<bool>> of_;  // by Body::loaded_as, then by loaded face
};

}  // namespace kerf
