#pragma once

#include <array>
#include <string>

#include "core/document/commands/command_reader.h"
#include "core/document/commands/command_writer.h"

namespace kerf {

// Ends the running stroke: the beam is off. A stroke with a smooth rim is smoothed here.
struct EndStroke {
  static constexpr const char* kName = "end";
  static constexpr std::array<const char*, 0> kKeys{};
  static constexpr std::array<const char*, 0> kOptionalKeys{};
  std::string words() const { return "End the stroke"; }
  size_t weight() const { return 0; }
  void write(CommandWriter&) const {}
  static Result<EndStroke> read(const CommandReader&) { return EndStroke{}; }
};

}  // namespace kerf
