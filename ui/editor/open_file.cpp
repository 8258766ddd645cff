#include "ui/editor/open_file.h"

#include "core/document/replay.h"
#include "core/mesh/load_notes.h"
#include "ui/editor/change_world.h"
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

// What is done to a scene once it is shown, its strokes and its journal, and what came of that.
struct Deeds {
  std::vector<StrokePath> strokes;
  Journal journal;
  Opened then;
  std::string fault;
  bool stopped = false;

  bool any() const { return !strokes.empty() || !journal.commands.empty(); }
};

void cut_all(Document& document, Deeds& deeds, const Progress& progress) {
  const auto ignore = [](const StepResult&) {};
  const Status cut = cut_strokes(document, deeds.strokes, ignore, &progress);
  if (!cut && !deeds.stopped) deeds.fault = cut.error().message;
}

// A step that fails here failed when the journal was made too.
void replay_all(Document& document, Deeds& deeds, const Progress& progress) {
  const Journal& journal = deeds.journal;
  Replay replay(journal, document);
  while (!replay.done() && progress.report(replay.fraction())) (void)replay.advance(kMovesOfStep);
  if (deeds.stopped) {
    document.apply(EndStroke{});
  } else if (!journal.damage.empty()) {
    deeds.fault = journal.damage;
  } else if (replay.difference()) {
    deeds.fault =
        "Cut another way than when it was saved: another version of Kerf made this journal, or it was "
        "changed";
  }
}

Delta run(Document& document, Deeds& deeds, const Progress& progress) {
  const Progress watched{[&](double fraction) {
    deeds.stopped = deeds.stopped || !progress.report(fraction);
    return !deeds.stopped;
  }};
  const double share = deeds.journal.commands.empty() ? 1 : 0.5;
  cut_all(document, deeds, share_of(&watched, 0, share));
  replay_all(document, deeds, share_of(&watched, deeds.strokes.empty() ? 0 : share, 1));
  Delta all;
  all.anew = true;
  return all;
}

void end_opening(EditorState& state, Deeds& deeds) {
  WorkInHand& work = state.work;
  work.marks = std::move(deeds.journal.marks);
  work.saved_commands = deeds.journal.damage.empty() ? state.document.journal().size() : WorkInHand::kNothing;
  if (!deeds.fault.empty()) state.say(deeds.fault, true);
  if (deeds.stopped) {
    state.say("Stopped: here is what was replayed of " + state.files.front().filename().string() +
              ", which stays as it is");
    work.file.clear();
    work.marks.clear();
  }
  deeds.then(!deeds.stopped);
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

Status open_files(EditorState& state, Renderer& renderer, std::span<const std::filesystem::path> files,
                  Opened then) {
  if (files.empty()) return Done{};
  Result<LoadedFiles> loaded = load_files({files.begin(), files.end()}, nullptr);
  if (!loaded) return loaded.error();
  show_loaded(state, renderer, std::move(*loaded), std::move(then));
  return Done{};
}

void show_loaded(EditorState& state, Renderer& renderer, LoadedFiles loaded, Opened then) {
  Scene& scene = loaded.work.scene;
  auto deeds = std::make_shared<Deeds>();
  deeds->strokes = scene.strokes;
  deeds->journal = std::move(loaded.work.journal);
  deeds->then = std::move(then);
  state.say(names_of(loaded.files) + note_of(scene.world));
  show_scene(state, renderer, std::move(scene), std::move(loaded.prepared));
  // Without hashes the work can be cut but not kept, which is said when it comes to that.
  if (loaded.cannot_be_kept) state.say(loaded.cannot_be_kept->message, true);
  state.work.saved_lights = state.look.lights;
  if (is_journal(loaded.files.front())) state.work.file = loaded.files.front();
  state.files = std::move(loaded.files);
  if (!deeds->any()) return end_opening(state, *deeds);
  LongChange change;
  change.title = "Opening " + names_of(state.files);
  change.can_stop = true;
  change.run = [deeds](Document& document, const Progress& progress) -> Result<Delta> {
    return run(document, *deeds, progress);
  };
  change.then = [&state, &renderer, deeds](const Result<Delta>& delta) {
    show_change(state, renderer, *delta);
    end_opening(state, *deeds);
  };
  state.long_change = std::move(change);
}

Status open_left_work(EditorState& state, Renderer& renderer, const LeftWork& left, Opened then) {
  Result<Scene> scene = load_scene(left.journal.scene);
  if (!scene) return scene.error();
  LoadedFiles loaded;
  for (const SceneBody& body : left.journal.scene.bodies) loaded.files.push_back(body.mesh);
  loaded.work = {std::move(*scene), left.journal};
  prepare(loaded);
  const auto is_here = [&state, work_of = left.journal.work_of, then = std::move(then)](bool whole) {
    if (whole && !state.message_is_error) state.say("Here is the work that was left");
    if (whole) {
      state.work.file = work_of;
      state.work.saved_commands = WorkInHand::kNothing;
    }
    then(whole);
  };
  show_loaded(state, renderer, std::move(loaded), is_here);
  return Done{};
}

}  // namespace kerf
