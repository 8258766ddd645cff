#pragma once

#include "ui/editor/state.h"

namespace kerf {

// Opens the window in which a file is chosen, in the folder where it was last.
void choose_file_for(EditorState& state, FileBrowser::Purpose purpose);

// Does what was chosen a file for: asks for it to be opened or saved to, or exports the chosen pieces to it.
// Returns why that cannot be, or an empty text.
std::string take_chosen_file(EditorState& state, FileBrowser::Purpose purpose,
                             const std::filesystem::path& file);

// Draws the window where it is open.
void draw_file_choice(EditorState& state);

}  // namespace kerf
