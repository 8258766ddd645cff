#pragma once

#include <filesystem>

namespace kerf {

// Where Kerf keeps a user's files, by the XDG Base Directory Specification; the folders need not exist.
// Settings: kerf under $XDG_CONFIG_HOME or, if that is no absolute path, under ~/.config.
std::filesystem::path settings_folder();
// Unsaved work and scores: kerf under $XDG_STATE_HOME or ~/.local/state.
std::filesystem::path state_folder();
// $HOME, or empty if it is not set.
std::filesystem::path home_folder();

}  // namespace kerf
