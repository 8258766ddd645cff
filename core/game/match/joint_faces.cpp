#include "core/game/match/joint_faces.h"

#include <algorithm>

namespace kerf {

JointFaces::JointFaces(const Joints& joints) {
  for (const Joint& joint : joints.all) {
    std::vector<bool>& carries = of_[joint.body];
    for (const JointSide& side : joint.sides) {
      if (side.faces.empty()) continue;
      if (carries.size() <= side.faces.back()) carries.resize(side.faces.back() + 1, false);
      for (const uint32_t f : side.faces) carries[f] = true;
    }
  }
}

const std::vector<bool>* JointFaces::of(const Body& body) const {
  const auto at = of_.find(body.loaded_as);
  return at == of_.end() ? nullptr : &at->second;
}

bool JointFaces::carries(const std::vector<bool>& carriers, const Body& body, FaceId f) {
  const FaceId loaded = body.loaded_face(body.loaded_base(f));
  return loaded.index < carriers.size() && carriers[loaded.index];
}

bool JointFaces::any_in(const Body& body) const {
  const std::vector<bool>* carriers = of(body);
  if (!carriers) return false;
  for (uint32_t slot = 0; slot < body.mesh.face_slots(); ++slot) {
    if (body.mesh.is_live(FaceId(slot)) && carries(*carriers, body, FaceId(slot))) return true;
  }
  return false;
}

bool JointFaces::any_of(const Body& body, const std::vector<FaceId>& faces) const {
  const std::vector<bool>* carriers = of(body);
  return carriers &&
         std::any_of(faces.begin(), faces.end(), [&](FaceId f) { return carries(*carriers, body, f); });
}

}  // namespace kerf
