#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/document/save.h"
#include "core/mesh/files/mesh_format.h"
#include "ui/editor/shared/file_preview.h"
#include "ui/editor/shared/settings.h"
#include "ui/editor/shared/thumbnails.h"

namespace kerf {

// The files that the dialog lists.
enum class FileKind { kAll, kMeshes, kScenes, kJournals, kDrawings, kPaths };

struct FolderEntry {
  std::string name;
  bool folder = false;
  uintmax_t bytes = 0;
};

// Lists the subfolders, then the files with an extension that can be opened, both by name and without hidden
// ones. `fault` becomes an error sentence, or empty.
std::vector<FolderEntry> list_folder(const std::filesystem::path& folder, std::string& fault);

// Returns true if a file with this name is of a kind, by its extension.
bool is_of_kind(const std::string& name, FileKind kind);

// Creates a folder "New Folder", or "New Folder 2" and so on if that exists. Returns its path, or an error
// sentence.
Result<std::filesystem::path> make_new_folder(const std::filesystem::path& parent);

// Returns true if a name contains the filter, ignoring case.
bool passes_filter(const std::string& name, const std::string& filter);

// Draws a row of the writable mesh formats. Returns the one that was clicked, if any.
std::optional<MeshFormat> draw_mesh_formats(MeshFormat current);

// Draws a line with the names of the files that an export writes, as many as fit.
void draw_file_names(std::span<const std::filesystem::path> files);

// Request for a file to open, save or export.
struct FileRequest {
  const char* title;
  const char* verb;                // on the button
  const char* hint;                // in the field for the name
  const char* listed = "";         // extension of the listed files; empty: all that can be opened
  FileKind only = FileKind::kAll;  // likewise, their kind
  // Extensions to write; a name without one gets the first. Empty: a file is opened, or `writes` is set.
  std::vector<std::string> endings = {};
  bool several = false;  // an export of several meshes, for which formats that hold them offer a single file
  // Takes the selected file. Returns an error, which keeps the window open, or an empty text.
  std::function<std::string(const std::filesystem::path&)> take;
  // For an export of meshes: returns the files that are written under this name.
  std::function<std::vector<std::filesystem::path>(const std::filesystem::path&)> writes = {};
  // For a file to write: returns the files that must not be replaced.
  std::function<InputFiles()> inputs = {};
  // For a file to open: previews the selected file as these settings do; null: no preview.
  const Settings* previewed_as = nullptr;
  Thumbnails* thumbnails = nullptr;  // of files whose faces a preview does not show; may be null
};

// The file dialog: folders and a filter by name. All of it can be used by keyboard.
struct FileBrowser {
  using Entry = FolderEntry;

  FileRequest request = {};
  MeshFormat format = MeshFormat::kObj;  // of an export; the last one selected
  bool single_file = false;              // of an export of several meshes, likewise
  FileKind kind = FileKind::kAll;        // of the files to open that are listed
  bool open = false;
  std::filesystem::path folder;
  std::vector<Entry> entries;     // of the folder: folders first, by name
  std::array<char, 1024> name{};  // a filter or path to open; the name to write
  std::string rest_of_path;       // of an absolute path to open: its part below `folder`, which filters
  size_t cursor = 0;              // index into the filtered entries
  bool is_selected = false;       // the cursor was set by the filter, a key or a click: Enter takes it
  std::string fault;              // error of the folder or of writing
  std::filesystem::path replace;  // an existing file, which is replaced if confirmed again

  // Keys received since the window was last drawn.
  struct Keys {
    int steps = 0;  // of the cursor
    bool first = false, last = false, enter = false, backspace = false, escape = false;
  } keys;
  bool take_focus = false, show_cursor = false;
  std::unique_ptr<FilePreviewer> preview;  // null before the first request
};

// Opens the window in a folder (the current one if it does not exist) with a name. Keeps `format`
// and `single_file`.
void browse(FileBrowser& browser, FileRequest request, std::filesystem::path folder, const std::string& name);

// Processes a key (GLFW_KEY_*) while the browser is open.
void browser_key(FileBrowser& browser, int key);

void draw_file_browser(FileBrowser& browser);

}  // namespace kerf
