#pragma once

#include <array>
#include <string>

#include "core/document/commands/command_reader.h"
#include "core/document/commands/command_writer.h"

namespace kerf {

// Moves the beam of the running stroke on, with the beam on all the way.
struct MoveStroke {
  Pose pose;        // world coordinates; the direction is not opposite to the one before
  double time = 0;  // s since the stroke began, not before the pose before; all 0 where times are not known

  static constexpr const char* kName = "move";
  static constexpr std::array<const char*, 2> kKeys{"origin", "direction"};
  static constexpr std::array<const char*, 1> kOptionalKeys{"t"};
  std::string words() const;
  size_t weight() const { return 0; }
  void write(CommandWriter& line) const;
  static Result<MoveStroke> read(const CommandReader& line);
};

}  // namespace kerf
