#include "core/document/commands/set_surroundings.h"

namespace kerf {

std::string SetSurroundings::words() const { return "Gravity and ground"; }

void SetSurroundings::write(CommandWriter& line) const {
  line.point("gravity", around.gravity);
  if (around.ground) line.number("ground", *around.ground);
  if (around.metre != 1) line.number("metre", around.metre);
}

Result<SetSurroundings> SetSurroundings::read(const CommandReader& line) {
  const auto gravity = line.point("gravity");
  if (!gravity) return gravity.error();
  SetSurroundings command;
  command.around.gravity = *gravity;
  if (line.has("ground")) {
    const auto ground = line.number("ground");
    if (!ground) return ground.error();
    command.around.ground = *ground;
  }
  if (line.has("metre")) {
    const auto metre = line.positive_number("metre");
    if (!metre) return metre.error();
    command.around.metre = *metre;
  }
  return command;
}

Result<Delta> SetSurroundings::run(World& world, uint32_t, const Progress*) const {
  Delta delta;
  if (world.surroundings() == around) return delta;
  world.set_surroundings(around);
  delta.surroundings = true;
  return delta;
}

}  // namespace kerf
