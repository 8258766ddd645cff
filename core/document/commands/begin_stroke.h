#pragma once

#include <array>
#include <string>

#include "core/document/commands/command_reader.h"
#include "core/document/commands/command_writer.h"

namespace kerf {

// Begins a stroke: the beam is on from here, at this pose (world coordinates), at time 0 of the stroke.
struct BeginStroke {
  CutSettings settings;
  Pose pose;

  static constexpr const char* kName = "begin";
  static constexpr std::array<const char*, 3> kKeys{"settings", "origin", "direction"};
  static constexpr std::array<const char*, 0> kOptionalKeys{};
  std::string words() const;
  size_t weight() const { return 0; }
  void write(CommandWriter& line) const;
  static Result<BeginStroke> read(const CommandReader& line);
};

}  // namespace kerf
