#include "ui/editor/shared/files/opening.h"

#include "core/base/assert.h"

namespace kerf {

void cancel_opening(Opening& opening, Message& message) {
  KERF_ASSERT(opening.loader.busy());
  message.say("Opening " + opening.loader.order().name() + " was cancelled: everything is as it was.");
  opening.loader.cancel();
  opening.left_work.clear();  // is offered at the next start
}

}  // namespace kerf
