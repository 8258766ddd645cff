#pragma once

#include <string>

#include "core/document/commands/command.h"

namespace kerf {

// A description of the command for the user, for example "Stroke, radius 4 mm". `unit` is the one in which
// the work is shown.
inline std::string words(const Command& command, FileUnit unit) {
  const auto told = [unit](const auto& c) {
    if constexpr (requires { c.words(unit); }) {
      return c.words(unit);
    } else {
      return c.words();
    }
  };
  return std::visit(told, command);
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
