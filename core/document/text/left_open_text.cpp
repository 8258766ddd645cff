#include "core/document/text/left_open_text.h"

namespace kerf {

std::string left_open_text(const LeftOpen& open, const World& world) {
  return world.contains(open.body) ? world.body(open.body).own_name() + ": " + open.why : open.why;
}

}  // namespace kerf
