#pragma once

#include <filesystem>
#include <string>

#include "ui/editor/shared/files/open_work.h"
#include "ui/editor/shared/picture/view_state.h"
#include "ui/editor/shared/settings/settings.h"
#include "ui/window/message.h"

namespace kerf {

// Whether there is anything that the file of the open work does not hold: commands, lights other than these,
// or what features keep in its head.
bool is_unsaved(const OpenWork& work, const std::vector<Light>& lights);
// Whether anything but cooling happened since: what was undone is not unsaved, but can be redone after a
// crash.
bool is_to_be_kept(const OpenWork& work, const std::vector<Light>& lights);

// The name of the open work for the user: that of its file, or of the file that it was opened from.
std::string name_of_work(const OpenWork& work);

// The title of the window: "car.kerf* - Kerf", with the star where something is not saved.
std::string window_title(const OpenWork& work, const std::vector<Light>& lights);

// A suggested name for a new file of the open work: "car.kerf".
std::string suggested_name(const OpenWork& work);

// The scene of the open work as it is looked at and lit at the moment.
SceneDescription scene_now(const OpenWork& work, const ViewState& view);

// Saves the open work: all of it as a journal, which Save writes to from then on, or where the name ends in
// .json its scene without what was cut. A name with neither ending gets .kerf. The version before is kept
// beside it with a ~ added to its name. The file becomes the first of the recent ones. Says in the status bar
// what became of it. Returns whether all of the work is saved.
bool save_work(OpenWork& work, const ViewState& view, std::filesystem::path file, Settings& settings,
               Message& message);

}  // namespace kerf
