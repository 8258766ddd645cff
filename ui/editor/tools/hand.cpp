#include "ui/editor/tools/hand.h"

namespace kerf {

bool cancel_stroke(Hand& hand, Document& document) {
  if (hand.drag != Drag::kCut) return false;
  hand.beam.release(document);
  hand.drag = Drag::kNone;
  return true;
}

}  // namespace kerf
