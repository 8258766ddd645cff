#include "ui/editor/files/save_work.h"

#include "core/document/history/lasting_commands.h"
#include "core/document/journal/save.h"
#include "ui/editor/shared/files/file_frames.h"

namespace kerf {

namespace {

namespace fs = std::filesystem;

std::vector<Light> lights_shown(const SceneDescription& scene) {
  return scene.lights.empty() ? std::vector{Light{}} : scene.lights;
}

Status write_all(OpenWork& work, const ViewState& view, const fs::path& file) {
  mark_state(work.document, work.marks, true);
  if (Status hashed = note_hashes(work.scene); !hashed) return hashed;
  return save_journal(file, scene_now(work, view), work.document.journal(), work.marks);
}

// Whether nobody misses it: what is hot has cooled down.
bool only_cools(const Command& command) {
  const AdvanceTime* time = std::get_if<AdvanceTime>(&command);
  return time != nullptr && !time->bodies;
}

// Whether the commands that last are those that were saved, besides what only cools: nothing came since, or
// all of it was taken back. What came last was not taken back unless it is undo or redo, which alone makes
// the time linear in the journal.
bool lasts_as_saved(const std::vector<Command>& journal, size_t saved) {
  size_t end = journal.size();
  while (end > saved && only_cools(journal[end - 1])) --end;
  if (end == saved) return true;
  if (!std::holds_alternative<Undo>(journal[end - 1]) && !std::holds_alternative<Redo>(journal[end - 1]))
    return false;
  const std::vector<bool> now = lasting_commands(journal),
                          then = lasting_commands(std::span(journal).first(saved));
  for (size_t i = 0; i < journal.size(); ++i) {
    const bool lasted = i < saved && then[i];
    if (now[i] != lasted && !only_cools(journal[i])) return false;
  }
  return true;
}

}  // namespace

bool is_to_be_kept(const OpenWork& work, const std::vector<Light>& lights) {
  const std::vector<Command>& journal = work.document.journal();
  if (work.saved_commands > journal.size() || lights != work.saved_lights) return true;
  if (work.scene.others != work.saved_head) return true;
  return !std::all_of(journal.begin() + static_cast<std::ptrdiff_t>(work.saved_commands), journal.end(),
                      only_cools);
}

bool is_unsaved(const OpenWork& work, const std::vector<Light>& lights) {
  if (!is_to_be_kept(work, lights)) return false;
  const bool dressed_as_saved = lights == work.saved_lights && work.scene.others == work.saved_head;
  const std::vector<Command>& journal = work.document.journal();
  return !dressed_as_saved || work.saved_commands > journal.size() ||
         !lasts_as_saved(journal, work.saved_commands);
}

std::string name_of_work(const OpenWork& work) {
  if (!work.file.empty()) return work.file.filename().string();
  if (work.files.empty()) return "Untitled";
  std::string name = work.files.front().filename().string();
  if (work.files.size() > 1) name += " and " + std::to_string(work.files.size() - 1) + " more";
  return name;
}

std::string window_title(const OpenWork& work, const std::vector<Light>& lights) {
  return name_of_work(work) + (is_unsaved(work, lights) ? "*" : "") + " - Kerf";
}

std::string suggested_name(const OpenWork& work) {
  if (!work.file.empty()) return work.file.filename().string();
  return (work.files.empty() ? "untitled" : work.files.front().stem().string()) + ".kerf";
}

SceneDescription scene_now(const OpenWork& work, const ViewState& view) {
  SceneDescription scene = work.scene;
  scene.view = View{view.seen().near().eye, view.camera.pivot()};
  note_frame(scene, view.frame);
  if (view.look.lights != lights_shown(scene)) scene.lights = view.look.lights;
  return scene;
}

bool save_work(OpenWork& work, const ViewState& view, fs::path file, Settings& settings, Message& message) {
  const bool scene_alone = file.extension() == ".json";
  if (!scene_alone && file.extension() != ".kerf") file += ".kerf";
  const Status saved = scene_alone ? save_scene(file, scene_now(work, view)) : write_all(work, view, file);
  if (!saved) {
    message.say(saved.error().message, true);
    return false;
  }
  if (!scene_alone) {
    work.file = file;
    work.saved_commands = work.document.journal().size();
  }
  work.saved_lights = view.look.lights;
  work.saved_head = work.scene.others;
  remember_recent(settings, file);
  const bool cut = is_unsaved(work, view.look.lights);
  message.say("Saved: " + file.string() +
              (cut ? ", without what was cut: save as .kerf to keep that too" : ""));
  return !cut;
}

}  // namespace kerf
