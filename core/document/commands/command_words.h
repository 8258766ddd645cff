#pragma once

#include <optional>
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

// The piece that a command names; nothing where it names none.
inline std::optional<PieceId> piece_of(const Command& command) {
  const auto named = [](const auto& c) -> std::optional<PieceId> {
    if constexpr (requires { c.piece; }) return c.piece;
    return std::nullopt;
  };
  return std::visit(named, command);
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
