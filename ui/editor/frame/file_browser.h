#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace kerf {

struct EditorState;

// The window in which a file is chosen: folders, a filter by name, all of it by keyboard too.
struct FileBrowser {
  enum class Purpose { kOpen, kSave, kExport };
  struct Entry {
    std::string name;
    bool folder = false;
    uintmax_t bytes = 0;
  };

  bool open = false;
  Purpose purpose = Purpose::kOpen;
  std::filesystem::path folder;
  std::vector<Entry> entries;     // of the folder, folders first, by name
  std::array<char, 1024> name{};  // a filter or a path to open; the name to write to
  size_t cursor = 0;              // in what the filter leaves
  std::string fault;              // why the folder cannot be shown, or the file not be written
  std::filesystem::path replace;  // a file that is there already; choosing it once more replaces it

  // Keys that came since the window was drawn last.
  struct Keys {
    int steps = 0;  // of the cursor
    bool first = false, last = false, enter = false, backspace = false, escape = false;
  } keys;
  bool take_focus = false, show_cursor = false;
};

// Opens the window in the folder where it was last.
void browse(EditorState& state, FileBrowser::Purpose purpose);

// A key (GLFW_KEY_*) while the window is open.
void browser_key(FileBrowser& browser, int key);

void draw_file_browser(EditorState& state);

// What the browser lists: folders, and files whose ending says that they can be opened; hidden ones are left
// out.
std::vector<FileBrowser::Entry> list_folder(const std::filesystem::path& folder, std::string& fault);

// Whether a name holds the filter, in any case of letters.
bool passes_filter(const std::string& name, const std::string& filter);

}  // namespace kerf
