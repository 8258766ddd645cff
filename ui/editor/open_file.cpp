#include "ui/editor/open_file.h"

#include "core/document/replay.h"
#include "core/document/work.h"
#include "core/mesh/load_notes.h"
#include "ui/render/scene_strokes.h"

namespace kerf {

namespace {

constexpr size_t kMovesOfStep = 64;

// Bodies, paints and strokes of several files as one scene; a view only where there is one file.
Result<Work> read_all(std::span<const std::filesystem::path> files) {
  if (files.size() == 1) return read_work(files.front());
  Work all;
  Scene& scene = all.scene;
  for (const std::filesystem::path& file : files) {
    if (is_journal(file)) return bad_input(file.string() + ": a journal is opened alone");
    Result<Scene> more = read_scene(file);
    if (!more) return more.error();
    for (const BodyId id : more->world.ids()) scene.world.add(std::move(more->world.body(id)));
    scene.bodies.insert(scene.bodies.end(), more->bodies.begin(), more->bodies.end());
    scene.paints.merge(more->paints);
    scene.strokes.insert(scene.strokes.end(), more->strokes.begin(), more->strokes.end());
  }
  return all;
}

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
  state.removed_faces += step.delta.removed_faces;
  state.last_step = step.figures;
  state.note_figures(step.figures);
  state.faces_before_step = state.document.world().live_faces();
}

void cut_strokes_of(EditorState& state, Renderer& renderer, const std::vector<StrokePath>& strokes) {
  size_t stroke = 0;
  const Status cut = cut_strokes(state.document, strokes, [&](const StepResult& step) {
    if (state.document.strokes() != stroke) state.removed_before_stroke = state.removed_faces;
    stroke = state.document.strokes();
    note_step(state, renderer, step);
  });
  if (cut) return;
  renderer.resend(state.document.world());
  state.say(cut.error().message, true);
}

// A step that fails here failed when the journal was made too.
void replay_all(EditorState& state, Renderer& renderer, const Journal& journal) {
  Replay replay(journal, state.document);
  while (!replay.done()) {
    const bool begins = state.document.waiting() == 0;
    const size_t before = state.removed_faces;
    const Result<StepResult> step = replay.advance(kMovesOfStep);
    if (begins && replay.begins_stroke()) state.removed_before_stroke = before;
    if (step) {
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
void show_scene(EditorState& state, Renderer& renderer, Scene scene) {
  const World::Bounds bounds = scene.world.bounds();
  renderer.show(scene.world, scene.paints);
  state.as_loaded.reset();
  if (scene.world.live_faces() <= Document::kMostFacesToRecut) state.as_loaded = scene.world;
  state.document = Document(std::move(scene.world));
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
  state.removed_faces = state.removed_before_stroke = 0;
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

void show_work(EditorState& state, Renderer& renderer, Work work) {
  const std::vector<StrokePath> strokes = work.scene.strokes;
  show_scene(state, renderer, std::move(work.scene));
  // Without hashes the work can be cut but not kept, which is said when it comes to that.
  if (const Status noted = note_hashes(state.work.scene); !noted) state.say(noted.error().message, true);
  cut_strokes_of(state, renderer, strokes);
  replay_all(state, renderer, work.journal);
  state.work.marks = std::move(work.journal.marks);
  state.work.saved_lights = state.look.lights;
  const bool whole = work.journal.damage.empty();
  state.work.saved_commands = whole ? state.document.journal().size() : WorkInHand::kNothing;
}

}  // namespace

Status open_files(EditorState& state, Renderer& renderer, std::span<const std::filesystem::path> files) {
  if (files.empty()) return Done{};
  Result<Work> work = read_all(files);
  if (!work) return work.error();
  state.files.assign(files.begin(), files.end());
  std::string note = names_of(files) + note_of(work->scene.world);
  state.say(std::move(note));
  show_work(state, renderer, std::move(*work));
  if (files.front().extension() == ".kerf") state.work.file = files.front();
  return Done{};
}

Status open_left_work(EditorState& state, Renderer& renderer, const LeftWork& left) {
  Result<Scene> scene = load_scene(left.journal.scene);
  if (!scene) return scene.error();
  state.files.clear();
  for (const SceneBody& body : left.journal.scene.bodies) state.files.push_back(body.mesh);
  state.say("Here is the work that was left");
  show_work(state, renderer, {std::move(*scene), left.journal});
  state.work.file = left.journal.work_of;
  state.work.saved_commands = WorkInHand::kNothing;
  return Done{};
}

}  // namespace kerf
