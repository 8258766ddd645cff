#pragma once

#include <vector>

#include "core/document/json_value.h"
#include "core/document/scene_joint.h"

namespace kerf {

// Parses the list "joints" of a body in a scene file. The error names the first wrong value.
Result<std::vector<SceneJoint>> parse_joints(const JsonValue& value);

nlohmann::ordered_json joint_json(const SceneJoint& joint);

}  // namespace kerf
