#pragma once

namespace kerf {

// A button that takes one of `shares` equal parts of the width of a panel. With a reason `why_not` it is
// disabled, and its tooltip says why; otherwise the tooltip is `meaning`. Returns whether it was pressed.
bool row_button(const char* label, int shares, const char* why_not, const char* meaning);

}  // namespace kerf
