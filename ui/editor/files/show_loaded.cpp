#include "core/base/assert.h"
#include "core/mesh/files/mesh_format.h"
#include "ui/editor/files/file_opener.h"
#include "ui/editor/shared/files/file_frames.h"
#include "ui/window/number_text.h"

namespace kerf {

namespace {

void dress_as(ViewState& view, const SceneDescription& scene, const FileFrame& frame) {
  view.home = scene.view;
  // The lights of a scene are in world coordinates, and the default light comes from above.
  if (scene.lights.empty()) {
    view.camera.set_up_axis(UpAxis::kY);
    view.look.lights = {Light{}};
  } else {
    view.camera.set_up_axis(frame.up);
    view.look.lights = scene.lights;
  }
  show_in_frame(view, frame);
  if (const auto show = parse_show_list(scene.show); show && !scene.show.empty()) view.look.show = *show;
}

// The first reason is in the status bar, the others are in the log.
void say_what_was_refused(Message& message, const LoadedFiles& loaded) {
  const size_t count = loaded.refused.size();
  for (size_t i = 1; i < count; ++i) message.note(loaded.refused[i], true);
  const std::string others =
      count == 1 ? "" : " (and " + std::to_string(count - 1) + " more, see Help > Messages)";
  message.say(loaded.order.name() + " opened, without: " + loaded.refused.front() + others, true);
}

std::string words_on_skip(Ticks skipped) {
  return "Bodies stand where " + grouped(skipped / kTicksPerSecond) +
         " s had brought them when it was saved; that time was not played again.";
}

void say_what_was_opened(Message& message, const LoadedFiles& loaded) {
  message.say(loaded.order.left ? "Here is the work that was left"
                                : loaded.order.name() + (loaded.notes.empty() ? "" : ": " + loaded.notes));
  // Without hashes the work can be cut but not kept, which is said when it comes to that.
  if (loaded.cannot_be_kept) message.say(loaded.cannot_be_kept->message, true);
  if (loaded.skipped > 0) message.say(words_on_skip(loaded.skipped));
  if (!loaded.fault.empty()) message.say(loaded.fault, true);
  if (!loaded.refused.empty()) say_what_was_refused(message, loaded);
}

// How much of the open work is saved, and where.
void note_what_is_saved(OpenWork& work, const LoadedFiles& loaded, const std::vector<Light>& lights) {
  const LoadOrder& order = loaded.order;
  KERF_ASSERT(order.left || !order.files.empty());
  work.files = order.files;
  work.file.clear();
  if (order.left) {
    work.files = order.left->opened;
    for (const SceneBody& body : loaded.scene.bodies) {
      if (order.left->opened.empty()) work.files.push_back(body.mesh);
    }
    work.file = order.left->work_of;
  } else if (is_journal(order.files.front())) {
    work.file = order.files.front();
  }
  const bool saved = !order.left && !loaded.damaged;
  work.saved_commands = saved ? work.document.journal().size() : OpenWork::kNothing;
  work.saved_lights = lights;
  work.saved_head = loaded.scene.others;
}

}  // namespace

void show_so_far(Workspace& on, CutSoFar so_far) {
  Renderer& renderer = on.picture->first();
  const bool is_new = !on.so_far;
  on.so_far = std::move(so_far.world);
  if (is_new) {
    const World::Bounds bounds = on.so_far->loaded_bounds();
    renderer.show(*on.so_far, so_far.scene.paints, std::move(so_far.prepared));
    dress_as(on.view, so_far.scene, choose_frame(so_far.scene, false, bounds, on.settings).frame);
    go_home(on.view, bounds);
    on.view.camera.finish();
  } else {
    renderer.resend(*on.so_far, std::move(so_far.prepared));
  }
  on.view.picture_old = true;
}

void show_loaded(Workspace& on, LoadedFiles loaded) {
  OpenWork& work = on.work;
  const bool was_shown = on.so_far.has_value();
  on.so_far.reset();
  work.document = std::move(loaded.document);
  work.as_loaded = std::move(loaded.as_loaded);
  work.paints = loaded.scene.paints;
  work.scene = loaded.scene;
  on.changes.forget();
  on.replaced();
  if (work.document.history().last_cut()) on.laser.show(work.document.history().last_settings());
  on.picture->first().show(work.document.world(), work.paints, std::move(loaded.prepared));
  on.view.numbers.follow(work.document.world(), true, false, on.view.look.pieces);
  const World::Bounds bounds = work.document.world().loaded_bounds();
  const bool is_mesh_file = !loaded.order.left && !loaded.order.files.empty() &&
                            mesh_format(loaded.order.files.front().extension().string()).has_value();
  const FrameChoice choice = choose_frame(loaded.scene, is_mesh_file, bounds, on.settings);
  on.view.frame_asked_for = choice.ask ? mesh_kind(loaded.scene) : "";
  dress_as(on.view, loaded.scene, choice.frame);
  if (!was_shown) {  // otherwise the user may have looked round
    go_home(on.view, bounds);
    on.view.camera.finish();
  }
  say_what_was_opened(on.message, loaded);
  note_what_is_saved(work, loaded, on.view.look.lights);
  work.marks = std::move(loaded.marks);
  on.view.picture_old = on.statistics.world_changed = true;
}

}  // namespace kerf
