#include "core/game/arena/model_body.h"

#include <utility>

namespace kerf {

Status add_joints(std::span<const SceneJoint> joints, ModelBody& model) {
  for (const SceneJoint& joint : joints) {
    auto made = make_joint(joint, BodyId{}, model.body);
    if (!made) return made.error();
    model.joints.push_back(std::move(*made));
  }
  return Done{};
}

BodyId add_body(World& world, const ModelBody& model, uint32_t generation) {
  const BodyId id = world.add(model.body, generation);
  if (model.joints.empty()) return id;
  Joints joints = world.joints();
  for (const Joint& joint : model.joints) joints.all.emplace_back(joint).body = id;
  world.set_joints(std::move(joints));
  return id;
}

}  // namespace kerf
