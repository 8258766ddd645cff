#include "core/document/commands/begin_stroke.h"

#include "core/base/length_text.h"
#include "core/document/text/fields.h"
#include "core/document/text/pose_fields.h"
#include "core/document/text/settings_fields.h"

namespace kerf {

std::string BeginStroke::words() const {
  return "Stroke, radius " + length_text(settings.laser.radius) +
         (settings.laser.pattern == Pattern::kRays4 ? ", four rays" : "");
}

void describe(Fields& f, BeginStroke& c) {
  f.object("settings", c.settings);
  describe(f, c.pose);
}

}  // namespace kerf
