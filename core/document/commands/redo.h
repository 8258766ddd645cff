#pragma once

#include <array>
#include <string>

#include "core/document/commands/command_reader.h"
#include "core/document/commands/command_writer.h"

namespace kerf {

// Does the step of the history again that was taken back last.
struct Redo {
  static constexpr const char* kName = "redo";
  static constexpr std::array<const char*, 0> kKeys{};
  static constexpr std::array<const char*, 0> kOptionalKeys{};
  std::string words() const { return "Redo"; }
  size_t weight() const { return 0; }
  void write(CommandWriter&) const {}
  static Result<Redo> read(const CommandReader&) { return Redo{}; }
};

}  // namespace kerf
