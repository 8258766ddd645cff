#include "ui/editor/files/watched_files.h"

#include <imgui.h>
#include <algorithm>

#include "core/base/assert.h"
#include "ui/editor/shared/command_labels.h"
#include "ui/window/widgets.h"

namespace kerf {

namespace fs = std::filesystem;

namespace {

constexpr float kCardUnderAxesEms = 9.6f;
constexpr ImGuiWindowFlags kCard = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize |
                                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav;

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

bool WatchedFiles::watches(const std::vector<fs::path>& files) const {
  return std::ranges::equal(files_, files, {}, &File::path);
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
  if (ImGui::Begin("##reload", nullptr, kCard)) {
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
