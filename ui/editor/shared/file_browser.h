#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/document/input_files.h"
#include "core/mesh/files/mesh_format.h"

namespace kerf {

struct FolderEntry {
  std::string name;
  bool folder = false;
  uintmax_t bytes = 0;
};

// Lists the folders in a folder, then the files whose ending says that they can be opened, both by name;
// hidden ones are left out. `fault` becomes a sentence where the folder cannot be read, or empty.
std::vector<FolderEntry> list_folder(const std::filesystem::path& folder, std::string& fault);

// Whether a name contains the filter, ignoring case.
bool passes_filter(const std::string& name, const std::string& filter);

// A row with the formats in which meshes are written. Returns the one that was clicked, if any.
std::optional<MeshFormat> draw_mesh_formats(MeshFormat current);

// A line with the names of the files that an export writes, as many as fit.
void draw_file_names(std::span<const std::filesystem::path> files);

// What a file is chosen for.
struct FileWish {
  const char* title;
  const char* verb;         // on the button
  const char* hint;         // in the field for the name
  const char* listed = "";  // the ending of the files that are listed; empty: all that can be opened
  // Endings of a file that is written; one without gets the first. Empty: a file is opened, or `writes` is
  // set.
  std::vector<std::string> endings = {};
  // Takes the file that was chosen. Returns why it cannot, and the window stays open, or an empty text.
  std::function<std::string(const std::filesystem::path&)> take;
  // For an export of meshes: the files that one under this name writes.
  std::function<std::vector<std::filesystem::path>(const std::filesystem::path&)> writes = {};
  // For a file that is written: the files that must not be replaced.
  std::function<InputFiles()> inputs = {};
};

// The window in which a file is chosen: folders, a filter by name, all of it by keyboard too.
struct FileBrowser {
  using Entry = FolderEntry;

  FileWish wish = {};
  MeshFormat format = MeshFormat::kObj;  // of an export; the one chosen last
  bool open = false;
  std::filesystem::path folder;
  std::vector<Entry> entries;     // of the folder, folders first, by name
  std::array<char, 1024> name{};  // a filter or a path to open; the name to write to
  size_t cursor = 0;              // in what the filter leaves
  bool is_chosen = false;         // the cursor, by a filter, by keys or by a click: Enter takes the entry
  std::string fault;              // why the folder cannot be shown, or the file not be written
  std::filesystem::path replace;  // a file that is there already; choosing it once more replaces it

  // Keys that came since the window was drawn last.
  struct Keys {
    int steps = 0;  // of the cursor
    bool first = false, last = false, enter = false, backspace = false, escape = false;
  } keys;
  bool take_focus = false, show_cursor = false;
};

// Opens the window in a folder, or in the current one where that does not exist, with a name to begin with.
// Keeps `format`.
void browse(FileBrowser& browser, FileWish wish, std::filesystem::path folder, const std::string& name);

// Processes a key (GLFW_KEY_*) while the browser is open.
void browser_key(FileBrowser& browser, int key);

// Draws the window where it is open.
void draw_file_browser(FileBrowser& browser);

}  // namespace kerf
