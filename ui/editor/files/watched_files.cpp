#include "ui/editor/files/watched_files.h"

#include <imgui.h>
#include <algorithm>
#include <charconv>
#include <fstream>
#include <sstream>

#include "core/base/assert.h"
#include "core/document/text/hash.h"
#include "core/mesh/files/mesh_format.h"
#include "core/mesh/files/mtl_file.h"
#include "core/mesh/files/side_file.h"
#include "ui/editor/shared/command_labels.h"
#include "ui/window/widgets.h"

namespace kerf {

namespace fs = std::filesystem;

namespace {

constexpr float kCardUnderAxesEms = 9.6f;
constexpr ImGuiWindowFlags kWatchedCard =
    ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
    ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav;
constexpr size_t kScannedBytes = 4 << 20;

std::string beginning_of(const fs::path& file) {
  std::error_code error;
  const uintmax_t size = fs::file_size(file, error);
  if (error) return "";
  std::ifstream in(file, std::ios::binary);
  std::string text(static_cast<size_t>(std::min<uintmax_t>(size, kScannedBytes)), '\0');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<size_t>(std::max<std::streamsize>(in.gcount(), 0)));
  return text;
}

// Appends a file once.
void add_file(std::vector<fs::path>& files, const std::optional<fs::path>& file) {
  if (file && std::ranges::find(files, *file) == files.end()) files.push_back(*file);
}

std::string without_outer_blanks(const std::string& text) {
  constexpr const char* kBlanks = " \t\r";
  const size_t begin = text.find_first_not_of(kBlanks);
  return begin == std::string::npos ? "" : text.substr(begin, text.find_last_not_of(kBlanks) + 1 - begin);
}

// The names after the keyword at the beginning of a line: one with blanks, or several.
void add_libraries(std::vector<fs::path>& files, const fs::path& folder, const std::string& names) {
  std::error_code error;
  if (const auto whole = side_file(folder, names); whole && fs::is_regular_file(*whole, error))
    return add_file(files, whole);
  std::istringstream words(names);
  for (std::string word; words >> word;) add_file(files, side_file(folder, word));
}

void add_files_of_obj(std::vector<fs::path>& files, const fs::path& mesh) {
  constexpr std::string_view kKeyword = "mtllib";
  const fs::path folder = mesh.parent_path();
  std::istringstream lines(beginning_of(mesh));
  for (std::string line; std::getline(lines, line);) {
    line = without_outer_blanks(line);
    if (!line.starts_with(kKeyword) || line.find_first_of(" \t") != kKeyword.size()) continue;
    std::string names = without_outer_blanks(line.substr(kKeyword.size()));
    for (std::string next; names.ends_with('\\') && std::getline(lines, next);) {
      names.back() = ' ';
      names += without_outer_blanks(next);
    }
    add_libraries(files, folder, names);
  }
  const std::vector<fs::path> libraries = files;
  for (const fs::path& library : libraries) {
    for (const std::string& image : parse_mtl(beginning_of(library)).references)
      add_file(files, side_file(image_folder(folder, library, image), image));
  }
}

// Decodes %20 and the like.
std::string decoded(std::string_view uri) {
  std::string text;
  for (size_t i = 0; i < uri.size(); ++i) {
    unsigned code = 0;
    const char* from = uri.data() + i + 1;
    if (uri[i] == '%' && i + 2 < uri.size() && std::from_chars(from, from + 2, code, 16).ptr == from + 2) {
      text += static_cast<char>(code);
      i += 2;
    } else {
      text += uri[i];
    }
  }
  return text;
}

// The values of the keys "uri" in JSON text, which may be that of a .glb.
void add_files_of_gltf(std::vector<fs::path>& files, const fs::path& mesh) {
  constexpr std::string_view kKey = "\"uri\"";
  const std::string text = beginning_of(mesh);
  for (size_t at = text.find(kKey); at != std::string::npos; at = text.find(kKey, at + 1)) {
    const size_t begin = text.find('"', at + kKey.size());
    const size_t end = begin == std::string::npos ? begin : text.find('"', begin + 1);
    if (end == std::string::npos) return;
    const std::string_view uri = std::string_view(text).substr(begin + 1, end - begin - 1);
    if (!uri.starts_with("data:")) add_file(files, side_file(mesh.parent_path(), decoded(uri)));
  }
}

}  // namespace

WatchedFiles::State WatchedFiles::state_of(const fs::path& file) {
  std::error_code no_time, no_size;
  const fs::file_time_type time = fs::last_write_time(file, no_time);
  const uintmax_t size = fs::file_size(file, no_size);
  if (no_time || no_size) return {};
  return {static_cast<int64_t>(time.time_since_epoch().count()), size};
}

void WatchedFiles::watch(const std::vector<fs::path>& files) {
  files_.clear();
  awaits_check_ = false;
  for (const fs::path& file : files) {
    const State now = state_of(file);
    files_.push_back({file, now, now});
  }
}

std::vector<fs::path> WatchedFiles::changed() {
  awaits_check_ = false;
  std::vector<fs::path> changed;
  for (File& file : files_) {
    const State now = state_of(file.path);
    const bool is_finished = now == file.seen && now != State();
    awaits_check_ = awaits_check_ || now != file.seen;
    file.seen = now;
    if (is_finished && now != file.known) changed.push_back(file.path);
  }
  return changed;
}

std::vector<fs::path> files_to_reload(const DocumentSession& session) {
  return session.file.empty() ? session.files : std::vector{session.file};
}

std::vector<fs::path> files_of(const DocumentSession& session) {
  std::vector<fs::path> files = files_to_reload(session);
  for (const SceneBody& body : session.scene.bodies) {
    if (!body.mesh.empty() && std::ranges::find(files, body.mesh) == files.end()) files.push_back(body.mesh);
  }
  return files;
}

std::vector<fs::path> side_files_of(const fs::path& mesh) {
  std::vector<fs::path> files;
  const auto format = mesh_format(mesh.extension().string());
  if (format == MeshFormat::kObj) add_files_of_obj(files, mesh);
  if (format && is_gltf(*format)) add_files_of_gltf(files, mesh);
  return files;
}

std::optional<fs::path> mismatched_mesh(const DocumentSession& session, const std::set<fs::path>& changed) {
  for (const SceneBody& body : session.scene.bodies) {
    if (!body.hash || !changed.contains(body.mesh)) continue;
    const Result<uint64_t> now = file_hash(body.mesh);
    if (!now || *now != *body.hash) return body.mesh;
  }
  return std::nullopt;
}

std::optional<fs::path> changed_buffer(const DocumentSession& session, const std::set<fs::path>& changed) {
  if (changed.empty()) return std::nullopt;
  for (const SceneBody& body : session.scene.bodies) {
    const auto format = mesh_format(body.mesh.extension().string());
    if (!format || !is_gltf(*format)) continue;
    for (const fs::path& side : side_files_of(body.mesh)) {
      if (side.extension() == ".bin" && changed.contains(side)) return side;
    }
  }
  return std::nullopt;
}

std::string words_on_changed(const std::vector<fs::path>& files) {
  KERF_ASSERT(!files.empty());
  const std::string name = files.front().filename().string();
  if (files.size() == 1) return name + " was changed by another program.";
  return name + " and " + count_text(files.size() - 1, "more file") + " were changed by other programs.";
}

ReloadChoice draw_reload_card(const std::vector<fs::path>& changed, const Area& viewport) {
  const float em = ImGui::GetFontSize();
  const auto right = static_cast<float>(viewport.at.x + viewport.size.x),
             top = static_cast<float>(viewport.at.y);
  ReloadChoice choice = ReloadChoice::kNone;
  ImGui::SetNextWindowPos({right - 0.8f * em, top + kCardUnderAxesEms * em}, ImGuiCond_Always, {1, 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 3);
  if (ImGui::Begin("##reload", nullptr, kWatchedCard)) {
    ImGui::TextUnformatted(words_on_changed(changed).c_str());
    if (ImGui::Button("Reload")) choice = ReloadChoice::kReload;
    mark_last_item("reload files");
    tooltip("Opens the document again from its files; asks first if it has unsaved changes.");
    ImGui::SameLine();
    if (ImGui::Button("Keep")) choice = ReloadChoice::kKeep;
    mark_last_item("keep files");
    tooltip("Keeps the open document. The next change of the files is offered again.");
  }
  ImGui::End();
  ImGui::PopStyleVar();
  return choice;
}

}  // namespace kerf
