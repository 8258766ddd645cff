#pragma once

#include "core/document/document.h"
#include "ui/editor/view/settings.h"
#include "ui/editor/work/requests.h"

namespace kerf {

// The steps of the history, to be travelled by a click, and the memory that they may take.
class HistoryPanel {
 public:
  void draw(Document& document, Settings& settings, Requests& requests);

 private:
  void draw_list(const Document& document, Requests& requests);

  size_t shown_ = 0;  // the position that the list was scrolled to
};

}  // namespace kerf
