#include "ui/editor/open_file.h"

#include "core/mesh/load_notes.h"
#include "ui/render/scene_strokes.h"

namespace kerf {

namespace {

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

void cut_strokes_of(EditorState& state, Renderer& renderer, const std::vector<StrokePath>& strokes) {
  size_t stroke = 0;
  const Status cut = cut_strokes(state.document, strokes, [&](const StepResult& step) {
    if (state.document.strokes() != stroke) state.removed_before_stroke = state.removed_faces;
    stroke = state.document.strokes();
    renderer.follow(step.delta);
    state.removed_faces += step.delta.removed_faces;
    state.last_step = step.figures;
    state.note_figures(step.figures);
    state.faces_before_step = state.document.world().live_faces();
  });
  if (cut) return;
  renderer.resend(state.document.world());
  state.say(cut.error().message, true);
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
  Scene* scene = &loaded.scene;
  const World::Bounds bounds = scene->world.bounds();
  renderer.show(scene->world, scene->paints, std::move(loaded.prepared));
  state.as_loaded.reset();
  if (scene->world.live_faces() <= Document::kMostFacesToRecut) state.as_loaded = scene->world;
  state.document = Document(std::move(scene->world));
  state.files = std::move(loaded.files);
  state.paints = std::move(scene->paints);
  state.home = scene->view;
  state.tool = LaserTool();
  state.drag = Drag::kNone;
  state.split.twin.forget();
  state.look.pieces.clear();
  state.look.tree.body.reset();
  state.look.lights = scene->lights.empty() ? std::vector{Light{}} : scene->lights;
  state.look.shadow.inspected = 0;
  if (const auto show = parse_show_list(scene->show); show && !scene->show.empty()) state.look.show = *show;
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
  state.say(names_of(state.files) + note_of(state.document.world()));
  cut_strokes_of(state, renderer, scene->strokes);
}

}  // namespace kerf
