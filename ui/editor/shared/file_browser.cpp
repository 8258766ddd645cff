#include "ui/editor/shared/file_browser.h"

#include <GLFW/glfw3.h>
#include <imgui.h>
#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <utility>

#include "core/base/assert.h"
#include "core/base/platform.h"
#include "core/document/job_files.h"
#include "core/document/journal.h"
#include "ui/window/layout.h"
#include "ui/window/widgets.h"

namespace kerf {

namespace fs = std::filesystem;

namespace {

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

bool can_be_opened(const fs::path& file) {
  const std::string ending = lower(file.extension().string());
  return ending == ".json" || is_journal(file) || mesh_format(ending).has_value();
}

struct Choice {
  MeshFormat format;
  const char *name, *tip;
};
constexpr std::array kChoices{
    Choice{MeshFormat::kObj, "OBJ", "Text, exact to the bit, with the names and colours of materials (MTL)."},
    Choice{MeshFormat::kPly, "PLY", "Binary, exact to the bit, without materials."},
    Choice{MeshFormat::kStl, "STL", "Binary in single precision, without materials; for printers."},
    Choice{MeshFormat::kOff, "OFF", "Text, exact to the bit, without materials."},
    Choice{MeshFormat::kGlb, "GLB", "Binary glTF 2.0 in single precision, with materials and textures."},
    Choice{MeshFormat::k3mf, "3MF",
           "Millimetres in single precision, with the colours of materials; for printers."}};

constexpr int kPage = 10;
constexpr float kListEms = 18, kPreviewEms = 16;

bool exports(const FileBrowser& b) { return b.request.writes != nullptr; }
bool previews(const FileBrowser& b) { return b.request.previewed_as != nullptr; }
bool opens(const FileBrowser& b) { return b.request.endings.empty() && !exports(b); }

bool is_listed(const FileBrowser& b, const FileBrowser::Entry& entry) {
  if (entry.folder) return true;
  if (exports(b)) return mesh_format(fs::path(entry.name).extension().string()).has_value();
  if (!is_of_kind(entry.name, b.request.only != FileKind::kAll ? b.request.only : b.kind)) return false;
  return entry.name.ends_with(b.request.listed);
}

void set_name(FileBrowser& b, const std::string& text) { fill_field(b.name, text); }

// Withdraws the question about files to be replaced, or the error of the last attempt.
void drop_fault(FileBrowser& b) {
  b.replace.clear();
  b.fault.clear();
}

void enter_folder(FileBrowser& b, const fs::path& folder) {
  std::error_code error;
  const fs::path whole = fs::weakly_canonical(folder, error);
  b.folder = error ? folder : whole;
  b.entries = list_folder(b.folder, b.fault);
  b.cursor = 0;
  b.is_selected = false;
  b.replace.clear();
  b.show_cursor = true;
  b.take_focus = true;
  if (opens(b)) set_name(b, "");
}

// Returns true if the typed text is a path from the home folder; names may begin with a tilde, too.
bool is_from_home(const std::string& text) { return text == "~" || text.starts_with("~/"); }
// Returns true if the typed text is a path from the root or from the home folder.
bool is_absolute(const std::string& text) { return text.starts_with('/') || is_from_home(text); }

std::vector<size_t> left_by_filter(const FileBrowser& b) {
  std::string filter = opens(b) ? b.name.data() : "";
  if (is_absolute(filter)) filter = b.rest_of_path;
  std::vector<size_t> left;
  for (size_t i = 0; i < b.entries.size(); ++i) {
    if (is_listed(b, b.entries[i]) && passes_filter(b.entries[i].name, filter)) left.push_back(i);
  }
  return left;
}

// Returns the path that was typed: absolute, from the home folder or, to open a file, with a slash.
std::optional<fs::path> typed_path(const FileBrowser& b) {
  const std::string text = b.name.data();
  if (text.empty()) return std::nullopt;
  if (text.front() == '/') return text;
  const fs::path home = home_folder();
  if (is_from_home(text) && !home.empty()) return home.string() + text.substr(1);
  if (!opens(b) || text.find('/') == std::string::npos) return std::nullopt;
  const fs::path relative = (b.folder / text).lexically_normal();
  return relative.has_filename() ? relative : relative.parent_path();
}

// Returns those of the files to be written that exist.
std::vector<fs::path> to_be_replaced(const FileBrowser& b, const fs::path& file) {
  if (opens(b)) return {};
  std::vector<fs::path> files = exports(b) ? b.request.writes(file) : std::vector{file};
  std::error_code error;
  std::erase_if(files, [&](const fs::path& f) { return !fs::exists(f, error); });
  return files;
}

// Lists the folder that an absolute path names while it is typed, or its parent filtered by the last name.
void follow_typed_path(FileBrowser& b) {
  if (!opens(b) || !is_absolute(b.name.data())) return;
  const fs::path typed = typed_path(b).value_or("/");
  std::error_code error;
  const bool is_folder = fs::is_directory(typed, error);
  const fs::path folder = is_folder && typed.has_filename() ? typed : typed.parent_path();
  b.rest_of_path = is_folder ? "" : typed.filename().string();
  if (is_folder) b.is_selected = false;  // Enter goes there
  if (folder == b.folder || !fs::is_directory(folder, error)) return;
  b.folder = folder;
  b.entries = list_folder(folder, b.fault);
}

void select_file(FileBrowser& b, const fs::path& file) {
  const std::vector<fs::path> there = to_be_replaced(b, file);
  const InputFiles inputs = b.request.inputs && !there.empty() ? b.request.inputs() : InputFiles();
  for (const fs::path& replaced : there) {
    const Status free = inputs.check(b.request.verb, replaced);
    if (free) continue;
    b.fault = free.error().message;
    return;
  }
  if (!there.empty() && b.replace != file) {
    b.replace = file;
    b.fault = there.front().filename().string() +
              (there.size() == 1 ? " already exists"
                                 : " and " + std::to_string(there.size() - 1) + " more already exist") +
              ": click Replace, or press Enter again";
    return;
  }
  b.fault = b.request.take(file);
  b.open = !b.fault.empty();
}

void select_entry(FileBrowser& b, const FileBrowser::Entry& entry) {
  const fs::path path = b.folder / entry.name;
  if (entry.folder) {
    enter_folder(b, path);
  } else if (opens(b)) {
    select_file(b, path);
  } else {
    set_name(b, entry.name);
  }
}

fs::path with_ending(fs::path file, const FileBrowser& b) {
  const std::string ending = file.extension().string();
  const std::vector<std::string>& endings = b.request.endings;
  if (exports(b) && !mesh_format(ending)) file += "." + std::string(format_row(b.format).ending);
  if (!endings.empty() && std::find(endings.begin(), endings.end(), ending) == endings.end())
    file += endings.front();
  return file;
}

// "Journal with All Cuts (.kerf)" if a document can be saved as several types, else the extension.
std::string type_name(const std::string& ending, bool is_only_type) {
  if (is_only_type) return ending;
  const char* name = ending == ".kerf" ? "Journal with All Cuts " : ending == ".json" ? "Scene " : "";
  return std::string(name) + (*name != '\0' ? "(" + ending + ")" : ending);
}

void accept(FileBrowser& b) {
  std::error_code error;
  const std::optional<fs::path> typed = typed_path(b);
  const bool in_list = typed && b.is_selected && !left_by_filter(b).empty() && is_absolute(b.name.data());
  if (typed && (!opens(b) || !in_list || fs::is_regular_file(*typed, error))) {
    if (!fs::is_directory(*typed, error)) return select_file(b, with_ending(*typed, b));
    set_name(b, "");
    return enter_folder(b, *typed);
  }
  if (!opens(b)) {
    const fs::path file = b.folder / b.name.data(), last = file.filename();
    if (b.name.front() == '\0') return;
    const bool may_be_folder = last.empty() || last == "." || last == "..";
    if (!may_be_folder || !fs::is_directory(file, error)) return select_file(b, with_ending(file, b));
    set_name(b, "");
    return enter_folder(b, file);
  }
  const std::vector<size_t> left = left_by_filter(b);
  if (!b.is_selected || b.cursor >= left.size()) return;
  const FileBrowser::Entry entry = b.entries[left[b.cursor]];
  select_entry(b, entry);
}

void draw_where(FileBrowser& b) {
  if (ImGui::Button("Up")) enter_folder(b, b.folder.parent_path());
  tooltip("Parent folder (Backspace)");
  ImGui::SameLine();
  if (!opens(b)) {
    if (ImGui::Button("New Folder")) {
      const auto made = make_new_folder(b.folder);
      if (made) enter_folder(b, *made);
      if (!made) b.fault = made.error().message;
    }
    mark_last_item("new folder");
    ImGui::SameLine();
  }
  ImGui::AlignTextToFramePadding();
  const float room = ImGui::GetContentRegionAvail().x;
  ImGui::TextUnformatted(fitted_end(b.folder.string(), room).c_str());
  tooltip(b.folder.c_str());
}

std::string size_text(uintmax_t bytes) {
  constexpr std::array kUnits{"B", "kB", "MB", "GB"};
  auto size = static_cast<double>(bytes);
  size_t unit = 0;
  for (; size >= 1000 && unit + 1 < kUnits.size(); ++unit) size /= 1000;
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), size < 10 && unit > 0 ? "%.1f %s" : "%.0f %s", size, kUnits[unit]);
  return text.data();
}

// Draws a size right-aligned, so that sizes can be compared.
void draw_size(uintmax_t bytes) {
  const std::string text = size_text(bytes);
  const float room = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(text.c_str()).x;
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(0.0f, room));
  ImGui::TextDisabled("%s", text.c_str());
}

void draw_entry(FileBrowser& b, size_t place, const FileBrowser::Entry& entry, bool& gone) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::PushID(static_cast<int>(place));
  const std::string label = whole_label(entry.folder ? entry.name + "/" : entry.name);
  constexpr ImGuiSelectableFlags kRow = ImGuiSelectableFlags_SpanAllColumns |
                                        ImGuiSelectableFlags_AllowDoubleClick |
                                        ImGuiSelectableFlags_DontClosePopups;
  const bool clicked = ImGui::Selectable(label.c_str(), b.is_selected && b.cursor == place, kRow);
  mark_last_item(("entry " + entry.name).c_str());
  const bool twice = ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
  if (b.cursor == place && b.show_cursor) ImGui::SetScrollHereY();
  ImGui::PopID();
  ImGui::TableNextColumn();
  if (!entry.folder) draw_size(entry.bytes);
  if (!clicked) return;
  b.cursor = place;
  b.is_selected = true;
  if (!opens(b) && !entry.folder) {
    set_name(b, entry.name);
    drop_fault(b);
  }
  if (!twice) return;
  const FileBrowser::Entry selected = entry;
  gone = true;
  select_entry(b, selected);
}

// Returns the width of the preview at the right of the list; 0 without one, or if the list needs the room.
float preview_room(const FileBrowser& b) {
  const float em = ImGui::GetFontSize(), room = ImGui::GetContentRegionAvail().x;
  return previews(b) && room > kListEms * em + kPreviewEms * em ? kPreviewEms * em : 0;
}

std::optional<fs::path> file_at_cursor(const FileBrowser& b) {
  std::error_code error;
  if (const auto typed = typed_path(b)) {
    if (fs::is_regular_file(*typed, error) && can_be_opened(*typed)) return typed;
    if (!is_absolute(b.name.data())) return std::nullopt;
  }
  const std::vector<size_t> left = left_by_filter(b);
  if (!b.is_selected || b.cursor >= left.size() || b.entries[left[b.cursor]].folder) return std::nullopt;
  return b.folder / b.entries[left[b.cursor]].name;
}

void draw_preview(FileBrowser& b, float height) {
  if (preview_room(b) == 0) return;
  const std::optional<fs::path> file = file_at_cursor(b);
  const Settings& settings = *b.request.previewed_as;
  b.preview->select(file ? std::optional<PreviewRequest>({*file, settings.theme, settings.frames})
                         : std::nullopt);
  ImGui::SameLine();
  if (ImGui::BeginChild("preview", {0, height}))
    b.preview->draw(file && b.request.thumbnails != nullptr ? b.request.thumbnails->find(whole_path(*file))
                                                            : std::nullopt);
  mark_window("file preview");
  ImGui::EndChild();
}

void draw_list(FileBrowser& b) {
  const std::vector<size_t> left = left_by_filter(b);
  if (!left.empty()) b.cursor = std::min(b.cursor, left.size() - 1);
  constexpr ImGuiTableFlags kList =
      ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersOuter;
  const float below = ImGui::GetTextLineHeightWithSpacing() + ImGui::GetFrameHeightWithSpacing();
  const float height = std::max(3 * ImGui::GetFontSize(), ImGui::GetContentRegionAvail().y - below);
  if (!ImGui::BeginTable("entries", 2, kList, {-preview_room(b), height})) return;
  ImGui::TableSetupColumn("Name", ImGuiTableColumnFlags_WidthStretch);
  ImGui::TableSetupColumn("Size", ImGuiTableColumnFlags_WidthFixed, 5 * ImGui::GetFontSize());
  bool gone = false;  // the entries are those of another folder now
  for (size_t place = 0; place < left.size() && !gone; ++place) {
    draw_entry(b, place, b.entries[left[place]], gone);
  }
  b.show_cursor = false;
  if (left.empty()) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextDisabled("%s", b.entries.empty() ? "No supported files in this folder" : "No matching files");
  }
  ImGui::EndTable();
  draw_preview(b, height);
}

void draw_name(FileBrowser& b) {
  const bool was_empty = b.name.front() == '\0';
  if (b.take_focus || !ImGui::IsAnyItemActive()) ImGui::SetKeyboardFocusHere();
  b.take_focus = false;
  ImGui::SetNextItemWidth(-1);
  if (ImGui::InputTextWithHint("##name", b.request.hint, b.name.data(), b.name.size(),
                               ImGuiInputTextFlags_AutoSelectAll)) {
    b.cursor = 0;
    b.is_selected = b.name.front() != '\0';
    drop_fault(b);
    follow_typed_path(b);
  }
  const FileBrowser::Keys keys = std::exchange(b.keys, {});
  if (keys.escape) b.open = false;
  if (keys.backspace && was_empty) enter_folder(b, b.folder.parent_path());
  const auto count = static_cast<std::ptrdiff_t>(left_by_filter(b).size());
  std::ptrdiff_t at = static_cast<std::ptrdiff_t>(b.cursor) + keys.steps;
  if (!b.is_selected && keys.steps > 0) --at;  // the first step selects the first entry
  if (keys.first) at = 0;
  if (keys.last) at = count;
  b.cursor = static_cast<size_t>(std::clamp<std::ptrdiff_t>(at, 0, std::max<std::ptrdiff_t>(count - 1, 0)));
  if (keys.steps != 0 || keys.first || keys.last) b.show_cursor = b.is_selected = true;
  if (keys.enter) {
    b.take_focus = true;
    accept(b);
  }
}

// The name gets the ending of the selected format; a typed ending selects its format.
void draw_export(FileBrowser& b) {
  const fs::path name = b.name.data();
  if (const auto typed = mesh_format(name.extension().string())) b.format = *typed;
  if (const auto selected = draw_mesh_formats(b.format)) {
    b.format = *selected;
    fs::path stem = name;
    if (mesh_format(name.extension().string())) stem.replace_extension();
    set_name(b, with_ending(stem, b).string());
    drop_fault(b);
    b.take_focus = true;
  }
  if (b.request.several && holds_several_meshes(b.format)) {
    if (ImGui::Checkbox("Single File", &b.single_file)) drop_fault(b);
    mark_last_item("single file");
    tooltip("Write all selected pieces to one file, each as a node or an object with its name.");
  }
  draw_file_names(b.request.writes(with_ending(b.folder / b.name.data(), b)));
}

// Draws the kinds of files that can be listed, or the extensions that can be written.
void draw_types(FileBrowser& b) {
  if (opens(b) && *b.request.listed == '\0' && b.request.only == FileKind::kAll) {
    constexpr std::array kKinds{"All", "Meshes", "Scenes", "Journals", "Drawings"};
    for (size_t i = 0; i < kKinds.size(); ++i) {
      if (i > 0) ImGui::SameLine();
      const auto kind = static_cast<FileKind>(i);
      if (ImGui::RadioButton(kKinds.at(i), b.kind == kind)) b.kind = kind, b.cursor = 0;
      mark_last_item(kKinds.at(i));
    }
  }
  const fs::path name = with_ending(b.name.data(), b);
  for (const std::string& ending : b.request.endings) {
    if (&ending != &b.request.endings.front()) ImGui::SameLine();
    const std::string type = type_name(ending, b.request.endings.size() == 1);
    if (ImGui::RadioButton(type.c_str(), name.extension() == ending) && b.name.front() != '\0') {
      set_name(b, fs::path(name).replace_extension(ending).string());
      drop_fault(b);
    }
    mark_last_item(("type " + ending).c_str());
  }
}

void draw_buttons(FileBrowser& b) {
  ImGui::PushTextWrapPos(0);
  if (b.fault.empty()) {
    ImGui::TextDisabled("%s", "Up/Down select - Enter confirm - Backspace parent folder - Esc cancel");
  } else {
    ImGui::TextUnformatted(error_sentence(b.fault).c_str());
  }
  ImGui::PopTextWrapPos();
  const char* verb = b.replace.empty() ? b.request.verb : "Replace";
  if (ImGui::Button(verb, {7 * ImGui::GetFontSize(), 0})) accept(b);
  ImGui::SameLine();
  if (ImGui::Button("Cancel", {7 * ImGui::GetFontSize(), 0})) b.open = false;
}

}  // namespace

bool is_of_kind(const std::string& name, FileKind kind) {
  const fs::path file = name;
  const std::string ending = lower(file.extension().string());
  switch (kind) {
    case FileKind::kMeshes:
      return mesh_format(ending).has_value();
    case FileKind::kScenes:
      return ending == ".json";
    case FileKind::kJournals:
      return is_journal(file);
    case FileKind::kDrawings:
      return is_drawing_file(file);
    case FileKind::kPaths:
      return job_kind(file) && !is_drawing_file(file);
    case FileKind::kAll:
      break;
  }
  return true;
}

Result<fs::path> make_new_folder(const fs::path& parent) {
  std::error_code error;
  for (int i = 1;; ++i) {
    const fs::path folder = parent / (i == 1 ? "New Folder" : "New Folder " + std::to_string(i));
    if (fs::create_directory(folder, error)) return folder;
    if (error) return bad_input(folder.string() + ": cannot create this folder: " + error.message());
  }
}

std::vector<FolderEntry> list_folder(const fs::path& folder, std::string& fault) {
  fault.clear();
  std::vector<FolderEntry> entries;
  std::error_code error;
  fs::directory_iterator at(folder, fs::directory_options::skip_permission_denied, error);
  for (; !error && at != fs::directory_iterator(); at.increment(error)) {
    const std::string name = at->path().filename().string();
    if (name.starts_with('.')) continue;
    std::error_code unknown;
    if (at->is_directory(unknown)) {
      entries.push_back({name, true, 0});
    } else if (at->is_regular_file(unknown) && (can_be_opened(at->path()) || job_kind(at->path()))) {
      const uintmax_t bytes = at->file_size(unknown);
      entries.push_back({name, false, unknown ? 0 : bytes});
    }
  }
  if (error) fault = folder.string() + ": cannot read this folder: " + error.message();
  std::sort(entries.begin(), entries.end(), [](const FolderEntry& a, const FolderEntry& b) {
    if (a.folder != b.folder) return a.folder;
    const std::string low_a = lower(a.name), low_b = lower(b.name);
    return low_a != low_b ? low_a < low_b : a.name < b.name;
  });
  return entries;
}

bool passes_filter(const std::string& name, const std::string& filter) {
  return lower(name).find(lower(filter)) != std::string::npos;
}

std::optional<MeshFormat> draw_mesh_formats(MeshFormat current) {
  std::optional<MeshFormat> selected;
  for (const Choice& choice : kChoices) {
    if (&choice != kChoices.data()) ImGui::SameLine();
    if (ImGui::RadioButton(choice.name, choice.format == current)) selected = choice.format;
    mark_last_item((std::string("format ") + choice.name).c_str());
    tooltip(choice.tip);
  }
  return selected;
}

void draw_file_names(std::span<const std::filesystem::path> files) {
  const float room = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(" ...").x;
  std::string text = "Writes";
  for (const std::filesystem::path& file : files) {
    const std::string more = (text == "Writes" ? " " : ", ") + file.filename().string();
    if (ImGui::CalcTextSize((text + more).c_str()).x > room) {
      text += " ...";
      break;
    }
    text += more;
  }
  ImGui::TextDisabled("%s", text.c_str());
}

void browse(FileBrowser& b, FileRequest request, fs::path folder, const std::string& name) {
  FileBrowser fresh;
  fresh.format = b.format;
  fresh.single_file = b.single_file;
  fresh.kind = b.kind;
  fresh.preview = std::move(b.preview);
  b = std::move(fresh);
  b.request = std::move(request);
  b.open = true;
  if (!b.preview) b.preview = std::make_unique<FilePreviewer>();
  std::error_code error;
  if (folder.empty() || !fs::is_directory(folder, error)) folder = fs::current_path(error);
  enter_folder(b, folder);
  set_name(b, name);
}

void browser_key(FileBrowser& browser, int key) {
  FileBrowser::Keys& keys = browser.keys;
  switch (key) {
    case GLFW_KEY_UP:
      --keys.steps;
      break;
    case GLFW_KEY_DOWN:
      ++keys.steps;
      break;
    case GLFW_KEY_PAGE_UP:
      keys.steps -= kPage;
      break;
    case GLFW_KEY_PAGE_DOWN:
      keys.steps += kPage;
      break;
    case GLFW_KEY_HOME:
      keys.first = true;
      break;
    case GLFW_KEY_END:
      keys.last = true;
      break;
    case GLFW_KEY_ENTER:
    case GLFW_KEY_KP_ENTER:
      keys.enter = true;
      break;
    case GLFW_KEY_BACKSPACE:
      keys.backspace = true;
      break;
    case GLFW_KEY_ESCAPE:
      keys.escape = true;
      break;
    default:
      break;
  }
}

void draw_file_browser(FileBrowser& b) {
  if (!b.open) return;
  KERF_ASSERT(b.request.take);
  const char* title = b.request.title;
  if (!ImGui::IsPopupOpen(title)) ImGui::OpenPopup(title);
  const float em = ImGui::GetFontSize();
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  const float width = previews(b) ? 58 : 44;
  ImGui::SetNextWindowSize({std::min(width * em, 0.92f * window.x), std::min(34 * em, 0.88f * window.y)});
  ImGui::SetNextWindowPos({0.5f * window.x, 0.5f * window.y}, ImGuiCond_Always, {0.5f, 0.5f});
  constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                                      ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings;
  bool wanted = true;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
  const bool drawn = ImGui::BeginPopupModal(title, &wanted, kFixed);
  ImGui::PopStyleVar();
  if (!drawn) return;
  draw_where(b);
  draw_name(b);
  if (exports(b)) draw_export(b);
  draw_types(b);
  draw_list(b);
  draw_buttons(b);
  if (!wanted) b.open = false;
  if (!b.open) ImGui::CloseCurrentPopup();
  if (!b.open) b.preview->select(std::nullopt);
  ImGui::EndPopup();
}

}  // namespace kerf
