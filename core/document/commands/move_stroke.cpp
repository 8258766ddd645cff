#include "core/document/commands/move_stroke.h"

namespace kerf {

std::string MoveStroke::words() const { return "Move the beam"; }

void MoveStroke::write(CommandWriter& line) const {
  line.pose(pose);
  if (time > 0) line.number("t", time);
}

Result<MoveStroke> MoveStroke::read(const CommandReader& line) {
  const auto pose = line.next_pose();
  if (!pose) return pose.error();
  const auto time = line.time();
  if (!time) return time.error();
  return MoveStroke{*pose, *time};
}

}  // namespace kerf
