#pragma once

#include <array>
#include <string>

#include "core/document/commands/command_reader.h"
#include "core/document/commands/command_writer.h"

namespace kerf {

// Begins a step of the history in which bodies move: the Advance commands that follow, up to the next stroke
// or edit, belong to it and are undone with it.
struct Play {
  static constexpr const char* kName = "play";
  static constexpr std::array<const char*, 0> kKeys{};
  static constexpr std::array<const char*, 0> kOptionalKeys{};
  std::string words() const { return "Play"; }
  size_t weight() const { return 0; }
  void write(CommandWriter&) const {}
  static Result<Play> read(const CommandReader&) { return Play{}; }
};

}  // namespace kerf
