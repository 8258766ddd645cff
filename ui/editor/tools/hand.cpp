#include "ui/editor/tools/hand.h"

namespace kerf {

bool cancel_stroke(Hand& hand, Document& document) {
  if (hand.drag != Drag::kCut && !hand.beam.cutting()) return false;
  hand.beam.release(document);
  if (hand.drag == Drag::kCut) hand.drag = Drag::kNone;
  return true;
}

}  // namespace kerf
