#include "ui/editor/panels/view_panel.h"

#include "ui/editor/panels/switch_row.h"

namespace kerf {

void draw_view_panel(ViewState& view) {
  for (const ViewSwitch& s : view_switches()) {
    if (s.in_view_panel) draw_switch(view, s.id);
  }
}

}  // namespace kerf
