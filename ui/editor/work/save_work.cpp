#include "ui/editor/work/save_work.h"

#include "core/document/save.h"

namespace kerf {

namespace {

namespace fs = std::filesystem;

std::vector<Light> lights_shown(const SceneDescription& scene) {
  return scene.lights.empty() ? std::vector{Light{}} : scene.lights;
}

bool save_scene_alone(EditorState& state, const fs::path& file) {
  SceneDescription scene = scene_now(state);
  if (const Status saved = save_scene(file, scene); !saved) {
    state.say(saved.error().message, true);
    return false;
  }
  state.work.saved_lights = state.look.lights;
  remember_recent(state.settings, file);
  const bool cut = is_unsaved(state);
  state.say("Saved: " + file.string() +
            (cut ? ", without what was cut: save as .kerf to keep that too" : ""));
  return !cut;
}

bool save_all(EditorState& state, const fs::path& file) {
  WorkInHand& work = state.work;
  mark_state(state.document, work.marks, true);
  Status saved = note_hashes(work.scene);
  if (saved) saved = save_journal(file, scene_now(state), state.document.journal(), work.marks);
  if (!saved) {
    state.say(saved.error().message, true);
    return false;
  }
  work.file = file;
  work.saved_commands = state.document.journal().size();
  work.saved_lights = state.look.lights;
  remember_recent(state.settings, file);
  state.say("Saved: " + file.string());
  return true;
}

}  // namespace

bool is_unsaved(const EditorState& state) {
  return state.document.journal().size() != state.work.saved_commands ||
         state.look.lights != state.work.saved_lights;
}

std::string name_of_work(const EditorState& state) {
  if (!state.work.file.empty()) return state.work.file.filename().string();
  if (state.files.empty()) return "Untitled";
  std::string name = state.files.front().filename().string();
  if (state.files.size() > 1) name += " and " + std::to_string(state.files.size() - 1) + " more";
  return name;
}

std::string window_title(const EditorState& state) {
  return name_of_work(state) + (is_unsaved(state) ? "*" : "") + " - Kerf";
}

std::string suggested_name(const EditorState& state) {
  if (!state.work.file.empty()) return state.work.file.filename().string();
  return (state.files.empty() ? "untitled" : state.files.front().stem().string()) + ".kerf";
}

SceneDescription scene_now(const EditorState& state) {
  SceneDescription scene = state.work.scene;
  scene.view = View{state.view().eye, state.camera.pivot()};
  if (state.look.lights != lights_shown(scene)) scene.lights = state.look.lights;
  return scene;
}

bool save_work(EditorState& state, fs::path file) {
  const bool scene_alone = file.extension() == ".json";
  if (!scene_alone && file.extension() != ".kerf") file += ".kerf";
  return scene_alone ? save_scene_alone(state, file) : save_all(state, file);
}

}  // namespace kerf
