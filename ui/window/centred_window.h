#pragma once

namespace kerf {

// A window in the middle of the screen that cannot be moved, of a size in sizes of the text or as large as
// the screen allows. `shown` becomes false when the user closes it. Returns whether its content is visible;
// end_centred_window() has to be called in any case. The window is a landmark.
bool begin_centred_window(const char* title, const char* landmark, bool& shown, float width_ems,
                          float height_ems);
void end_centred_window();

}  // namespace kerf
