#pragma once

#include <filesystem>
#include <string>

#include "ui/editor/editor_state.h"

namespace kerf {

// Whether there is anything that the file of the open work does not hold: commands, and lights that were
// moved.
bool is_unsaved(const EditorState& state);

// What the open work is called, for people: the name of its file, or of what it was opened from.
std::string name_of_work(const EditorState& state);

// What the window says: "car.kerf* - Kerf", with the star while it is unsaved.
std::string window_title(const EditorState& state);

// What a new file of the open work may be called: "car.kerf".
std::string suggested_name(const EditorState& state);

// The scene of the open work as it is looked at and lit now.
SceneDescription scene_now(const EditorState& state);

// Saves the open work: all of it as a journal, which Save writes to from then on, or where the name ends in
// .json its scene without what was cut. A name with neither ending gets .kerf. The version before is kept
// beside it with a ~ added to its name. Says in the status bar what became of it; whether all of the work is
// saved.
bool save_work(EditorState& state, std::filesystem::path file);

}  // namespace kerf
