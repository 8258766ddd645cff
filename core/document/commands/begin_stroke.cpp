#include "core/document/commands/begin_stroke.h"

#include "core/base/length_text.h"

namespace kerf {

std::string BeginStroke::words() const {
  return "Stroke, radius " + length_text(settings.laser.radius) +
         (settings.laser.pattern == Pattern::kRays4 ? ", four rays" : "");
}

void BeginStroke::write(CommandWriter& line) const {
  line.settings(settings);
  line.pose(pose);
}

Result<BeginStroke> BeginStroke::read(const CommandReader& line) {
  const auto settings = line.settings();
  if (!settings) return settings.error();
  const auto pose = line.pose();
  if (!pose) return pose.error();
  return BeginStroke{*settings, *pose};
}

}  // namespace kerf
