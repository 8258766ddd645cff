#include "ui/editor/changes/split_view.h"

namespace kerf {

void show_split(SplitView& split, bool shown, Hand& hand, Document& document, ViewState& view) {
  cancel_stroke(hand, document);
  split.shown = shown;
  split.twin.forget();
  view.in_second = false;
  view.picture_old = true;
}

}  // namespace kerf
