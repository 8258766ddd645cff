#pragma once

#include <array>
#include <string>

#include "core/document/commands/command_reader.h"
#include "core/document/commands/command_writer.h"

namespace kerf {

// Takes the last step of the history back; a stroke with all its moves is one step.
struct Undo {
  static constexpr const char* kName = "undo";
  static constexpr std::array<const char*, 0> kKeys{};
  static constexpr std::array<const char*, 0> kOptionalKeys{};
  std::string words() const { return "Undo"; }
  size_t weight() const { return 0; }
  void write(CommandWriter&) const {}
  static Result<Undo> read(const CommandReader&) { return Undo{}; }
};

}  // namespace kerf
