#pragma once

namespace kerf {

// Rows of a panel: the label left, the value right in a column of one width. Between begin and end, call
// property() and then the one widget of the row, which gets its tooltip from property_tooltip().
bool begin_properties(const char* id);
void property(const char* label);
void end_properties();

// Shown when the pointer rests on the last item for half a second, disabled items included.
void tooltip(const char* text);

}  // namespace kerf
