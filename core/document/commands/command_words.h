#pragma once

#include <optional>
#include <string>

#include "core/document/commands/command.h"
#include "core/document/commands/edit_piece.h"

namespace kerf {

// The piece that a command names; nothing where it names none.
inline std::optional<PieceId> piece_of(const Command& command) {
  const auto named = [](const auto& c) -> std::optional<PieceId> {
    if constexpr (requires { c.piece; }) return c.piece;
    return std::nullopt;
  };
  return std::visit(named, command);
}

// A description of the command for the user, for example "Stroke, radius 4 mm". `unit` is the one in which
// the work is shown. The piece that it names is called `piece_name`, or where that is empty by its number.
inline std::string words(const Command& command, FileUnit unit, const std::string& piece_name = "") {
  const auto told = [&](const auto& c) {
    if constexpr (requires { c.words(unit); }) {
      return c.words(unit);
    } else if constexpr (requires { c.words(piece_name); }) {
      return c.words(piece_name.empty() ? piece_words(c.piece) : piece_name);
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
