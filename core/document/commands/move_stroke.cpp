#include "core/document/commands/move_stroke.h"

#include "core/document/text/fields.h"
#include "core/document/text/pose_fields.h"

namespace kerf {

std::string MoveStroke::words() const { return "Move the beam"; }

void describe(Fields& f, MoveStroke& c) {
  describe(f, c.pose);
  f.number("t", c.time, kFinite, 0);
}

}  // namespace kerf
