#include "core/world/joint.h"

#include <algorithm>

namespace kerf {

bool Joints::carries(BodyId body, FaceId loaded) const {
  return std::any_of(all.begin(), all.end(), [&](const Joint& joint) {
    return joint.body == body && std::any_of(joint.sides.begin(), joint.sides.end(), [&](const JointSide& s) {
             return std::binary_search(s.faces.begin(), s.faces.end(), loaded.index);
           });
  });
}

}  // namespace kerf
