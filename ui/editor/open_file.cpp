#include "ui/editor/open_file.h"

#include "core/document/replay.h"
#include "core/mesh/load_notes.h"
#include "ui/render/scene_strokes.h"

namespace kerf {

namespace {

constexpr size_t kMovesOfStep = 64;

std::string names_of(std::span<const std::filesystem::path> files) {
  std::string names = files.front().filename().string();
  if (files.size() > 1) names += " and " + std::to_string(files.size() - 1) + " more";
  return names;
}

// What was put right in the first file that needed it, or nothing.
std::string note_of(const World& world) {
  for (const BodyId id : world.ids()) {
    const std::vector<std::string> notes = load_notes(world.body(id).loaded);
    if (!notes.empty()) return ": " + notes.front();
  }
  return "";
}

void note_step(EditorState& state, Renderer& renderer, const StepResult& step) {
  renderer.follow(step.delta);
  state.last_step = step.figures;
  state.note_figures(step.figures);
  state.faces_before_step = state.document.world().live_faces();
}

void cut_strokes_of(EditorState& state, Renderer& renderer, const std::vector<StrokePath>& strokes) {
  const Status cut =
      cut_strokes(state.document, strokes, [&](const StepResult& step) { note_step(state, renderer, step); });
  if (cut) return;
  renderer.resend(state.document.world());
  state.say(cut.error().message, true);
}

// A step that fails here failed when the journal was made too.
void replay_all(EditorState& state, Renderer& renderer, const Journal& journal) {
  Replay replay(journal, state.document);
  while (!replay.done()) {
    const Result<StepResult> step = replay.advance(kMovesOfStep);
    if (step && !step->delta.anew) {
      note_step(state, renderer, *step);
    } else {
      renderer.resend(state.document.world());
    }
  }
  if (!journal.damage.empty()) {
    state.say(journal.damage, true);
  } else if (replay.difference()) {
    state.say(
        "Cut another way than when it was saved: another version of Kerf made this journal, or it was "
        "changed",
        true);
  }
}

// Puts a scene in place of what is open, as it was loaded.
void show_scene(EditorState& state, Renderer& renderer, Scene scene, PreparedBodies prepared) {
  const World::Bounds bounds = scene.world.bounds();
  renderer.show(scene.world, scene.paints, std::move(prepared));
  state.as_loaded.reset();
  if (scene.world.live_faces() <= Document::kMostFacesToCopy) state.as_loaded = scene.world;
  const SceneDescription origin = scene;
  state.document = Document(std::move(scene.world), [origin](const Progress* progress) -> Result<World> {
    Result<Scene> again = load_scene(origin, progress);
    if (!again) return again.error();
    return std::move(again->world);
  });
  state.document.set_window(state.settings.history_bytes());
  state.paints = scene.paints;
  state.home = scene.view;
  state.tool = LaserTool();
  state.drag = Drag::kNone;
  state.split.twin.forget();
  state.look.pieces.clear();
  state.look.tree.body.reset();
  state.look.lights = scene.lights.empty() ? std::vector{Light{}} : scene.lights;
  state.look.shadow.inspected = 0;
  if (const auto show = parse_show_list(scene.show); show && !scene.show.empty()) state.look.show = *show;
  state.spread = 0;
  state.laser.fit(bounds.diagonal());
  state.last_step = state.stroke_figures = {};
  state.faces_before_step = 0;
  state.cut_once = false;
  state.picture_old = state.world_changed = true;
  if (state.home) {
    state.camera.look(state.home->eye, state.home->target);
  } else {
    state.camera.frame_default(bounds, state.aspect());
  }
  state.camera.finish();
  state.work = WorkInHand();
  state.work.scene = std::move(scene);
}

}  // namespace

Status open_files(EditorState& state, Renderer& renderer, std::span<const std::filesystem::path> files) {
  if (files.empty()) return Done{};
  Result<LoadedFiles> loaded = load_files({files.begin(), files.end()}, nullptr);
  if (!loaded) return loaded.error();
  show_loaded(state, renderer, std::move(*loaded));
  return Done{};
}

void show_loaded(EditorState& state, Renderer& renderer, LoadedFiles loaded) {
  Work& work = loaded.work;
  state.say(names_of(loaded.files) + note_of(work.scene.world));
  const std::vector<StrokePath> strokes = work.scene.strokes;
  show_scene(state, renderer, std::move(work.scene), std::move(loaded.prepared));
  // Without hashes the work can be cut but not kept, which is said when it comes to that.
  if (loaded.cannot_be_kept) state.say(loaded.cannot_be_kept->message, true);
  cut_strokes_of(state, renderer, strokes);
  replay_all(state, renderer, work.journal);
  state.work.marks = std::move(work.journal.marks);
  state.work.saved_lights = state.look.lights;
  const bool whole = work.journal.damage.empty();
  state.work.saved_commands = whole ? state.document.journal().size() : WorkInHand::kNothing;
  if (is_journal(loaded.files.front())) state.work.file = loaded.files.front();
  state.files = std::move(loaded.files);
}

Status open_left_work(EditorState& state, Renderer& renderer, const LeftWork& left) {
  Result<Scene> scene = load_scene(left.journal.scene);
  if (!scene) return scene.error();
  LoadedFiles loaded;
  for (const SceneBody& body : left.journal.scene.bodies) loaded.files.push_back(body.mesh);
  loaded.work = {std::move(*scene), left.journal};
  prepare(loaded);
  show_loaded(state, renderer, std::move(loaded));
  if (!state.message_is_error) state.say("Here is the work that was left");
  state.work.file = left.journal.work_of;
  state.work.saved_commands = WorkInHand::kNothing;
  return Done{};
}

}  // namespace kerf
