#pragma once

#include "ui/editor/state.h"

namespace kerf {

// Opens the file browser in the folder that it showed last.
void choose_file_for(EditorState& state, FileBrowser::Purpose purpose);

// Uses the chosen file: requests that it is opened or saved to, or exports the selected pieces to it. Returns
// the reason if that is impossible, else an empty text.
std::string take_chosen_file(EditorState& state, FileBrowser::Purpose purpose,
                             const std::filesystem::path& file);

// Draws the file browser if it is open.
void draw_file_choice(EditorState& state);

}  // namespace kerf
