#pragma once

#include <nlohmann/json.hpp>

#include "core/base/vec3.h"

namespace kerf {

inline nlohmann::ordered_json json_vector(const Vec3& v) { return {v.x, v.y, v.z}; }

}  // namespace kerf
