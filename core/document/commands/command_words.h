#pragma once

#include <string>

#include "core/document/commands/command.h"

namespace kerf {

// A description of the command for the user, for example "Stroke, radius 4 mm".
inline std::string words(const Command& command) {
  return std::visit([](const auto& c) { return c.words(); }, command);
}

// The memory that a command occupies, in bytes.
inline size_t weight(const Command& command) {
  const auto owned = [](const auto& c) -> size_t {
    if constexpr (requires { c.weight(); }) return c.weight();
    return 0;
  };
  return sizeof(Command) + std::visit(owned, command);
}

}  // namespace kerf
