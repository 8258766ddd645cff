#include "core/document/history/stop_strokes.h"

namespace kerf {

Outcome stop_strokes(Document& document) {
  document.apply(EndStroke{});
  Outcome all;
  const History& history = document.history();
  while (all.ok() && document.execution().beam_waits() && history.position() > 0 && history.last().waiting())
    all.append(document.apply(Undo{}));
  if (!all.ok()) return all;
  if (const auto here = document.execution().stop_here()) all.append(document.apply(*here));
  return all;
}

}  // namespace kerf
