#include "ui/editor/work/open_file.h"

namespace kerf {

namespace {

// What belonged to the world that was open.
void forget_what_was_open(EditorState& state) {
  state.tool = LaserTool();
  state.drag = Drag::kNone;
  state.split.twin.forget();
  state.look.pieces.clear();
  state.look.tree.body.reset();
  state.look.shadow.inspected = 0;
  state.spread = 0;
  state.last_step = state.stroke_figures = {};
  state.faces_before_step = 0;
  state.cut_once = false;
}

void dress_as(EditorState& state, const SceneDescription& scene) {
  state.paints = scene.paints;
  state.home = scene.view;
  state.look.lights = scene.lights.empty() ? std::vector{Light{}} : scene.lights;
  if (const auto show = parse_show_list(scene.show); show && !scene.show.empty()) state.look.show = *show;
}

void stand_before(EditorState& state, const World::Bounds& bounds) {
  state.laser.fit(bounds.diagonal());
  if (state.home) {
    state.camera.look(state.home->eye, state.home->target);
  } else {
    state.camera.frame_default(bounds, state.aspect());
  }
  state.camera.finish();
}

void take_in_hand(EditorState& state, LoadedFiles& loaded) {
  const LoadOrder& order = loaded.order;
  WorkInHand& work = state.work = WorkInHand();
  state.files = order.files;
  if (order.left) {
    for (const SceneBody& body : loaded.scene.bodies) state.files.push_back(body.mesh);
    work.file = order.left->work_of;
  } else if (is_journal(order.files.front())) {
    work.file = order.files.front();
  }
  const bool saved = !order.left && !loaded.damaged;
  work.saved_commands = saved ? state.document.journal().size() : WorkInHand::kNothing;
  work.saved_lights = state.look.lights;
  work.marks = std::move(loaded.marks);
  work.scene = std::move(loaded.scene);
}

void say_what_was_opened(EditorState& state, const LoadedFiles& loaded) {
  state.say(loaded.order.left ? "Here is the work that was left"
                              : loaded.order.name() + (loaded.notes.empty() ? "" : ": " + loaded.notes));
  // Without hashes the work can be cut but not kept, which is said when it comes to that.
  if (loaded.cannot_be_kept) state.say(loaded.cannot_be_kept->message, true);
  if (!loaded.fault.empty()) state.say(loaded.fault, true);
}

}  // namespace

void show_loaded(EditorState& state, Renderer& renderer, LoadedFiles loaded) {
  forget_what_was_open(state);
  state.document = std::move(loaded.document);
  state.as_loaded = std::move(loaded.as_loaded);
  renderer.show(state.document.world(), loaded.scene.paints, std::move(loaded.prepared));
  dress_as(state, loaded.scene);
  stand_before(state, state.document.world().loaded_bounds());
  say_what_was_opened(state, loaded);
  take_in_hand(state, loaded);
  state.picture_old = state.world_changed = true;
}

}  // namespace kerf
