#include "ui/editor/open_file.h"

#include "ui/render/scene_strokes.h"

namespace kerf {

Status open_file(EditorState& state, Renderer& renderer, const std::filesystem::path& file) {
  Result<Scene> scene = read_scene(file);
  if (!scene) return scene.error();
  const World::Bounds bounds = scene->world.bounds();
  renderer.show(scene->world, scene->paints);
  state.document = Document(std::move(scene->world));
  state.paints = std::move(scene->paints);
  state.home = scene->view;
  state.tool = LaserTool();
  state.drag = Drag::kNone;
  state.laser.fit(bounds.diagonal());
  state.removed_faces = 0;
  state.cut_once = false;
  state.picture_old = true;
  if (state.home) {
    state.camera.look(state.home->eye, state.home->target);
  } else {
    state.camera.frame_default(bounds, state.aspect());
  }
  state.camera.finish();
  state.say(file.filename().string());
  const Status cut = cut_strokes(state.document, scene->strokes, [&](const StepResult& step) {
    renderer.follow(step.delta);
    state.removed_faces += step.delta.removed_faces;
  });
  if (!cut) {
    renderer.resend(state.document.world());
    state.say(cut.error().message, true);
  }
  return Done{};
}

}  // namespace kerf
