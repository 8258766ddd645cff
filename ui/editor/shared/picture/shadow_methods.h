#pragma once

#include <span>

#include "core/shadow/shadow_volume.h"

namespace kerf {

// A shadow method as people are told of it.
struct MethodWords {
  ShadowMethod method;
  const char* name;
  const char* meaning;
};
std::span<const MethodWords> shadow_methods();

const char* method_name(ShadowMethod method);

}  // namespace kerf
