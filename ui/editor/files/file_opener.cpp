#include "ui/editor/files/file_opener.h"

#include "core/base/assert.h"

namespace kerf {

namespace {
constexpr double kShowWindowAfter = 0.2;  // s, at the start, until the window shows something
}  // namespace

// What is read in a moment is there at once.
Status FileOpener::open_first(std::filesystem::path default_scene,
                              const std::vector<std::filesystem::path>& files) {
  default_scene_ = std::move(default_scene);
  if (files.empty()) return open_default_scene();
  show_empty_stage();
  on_.opening.loader.start(order_of(files), stage_is_empty_);
  if (on_.opening.loader.is_over(kShowWindowAfter)) take_loaded();
  return Done{};
}

// Nothing but the ground, seen from three-quarter in front.
void FileOpener::show_empty_stage() {
  stage_is_empty_ = true;
  on_.picture->first().show(on_.work.document.world(), {}, {});
  on_.work.saved_lights = on_.view.look.lights;
  go_home(on_.view, {Vec3(-1), Vec3(1)});
  on_.view.camera.finish();
}

LoadOrder FileOpener::order_of(std::vector<std::filesystem::path> files) const {
  return {std::move(files), {}, on_.settings.history_bytes()};
}

Status FileOpener::open_default_scene() {
  Result<LoadedFiles> loaded = load_files(order_of({default_scene_}), nullptr);
  if (!loaded) return loaded.error();
  show(std::move(*loaded));
  return Done{};
}

// What was open until then is kept no longer.
void FileOpener::show(LoadedFiles loaded) {
  stage_is_empty_ = false;
  shadows_due_ = loaded.shadows_later;
  on_.picture->draft(shadows_due_);
  show_loaded(on_, std::move(loaded));
  recovery_.drop();
  recovery_.begin(on_.work, on_.view);
}

void FileOpener::make_shadows() {
  Renderer& renderer = on_.picture->first();
  if (!shadows_due_ || renderer.is_sending() || !on_.picture->shows_draft()) return;
  if (on_.changes.is_pending() || on_.cutting()) return;
  shadows_due_ = false;
  const auto casters = std::make_shared<PreparedBodies>();
  LongChange change;
  change.title = "Shadows";
  change.run = [casters, loaded = renderer.loaded_shadings()](Document& document, const Progress& progress) {
    for (const BodyId id : document.world().ids())
      (*casters)[id].frame = loaded.at(document.world().body(id).loaded_as).frame;
    Outcome outcome;
    if (const Status made = prepare_shadows(document.world(), *casters, &progress); !made)
      outcome.fail(made.error());
    return outcome;
  };
  change.then = [this, casters](const Outcome&) {
    on_.picture->first().take_casters(std::move(*casters));
    on_.picture->draft(false);
    on_.view.picture_old = true;
  };
  on_.changes.begin(std::move(change));
}

void FileOpener::open(std::vector<std::filesystem::path> files) {
  KERF_ASSERT(!files.empty());
  if (on_.so_far) {
    on_.so_far.reset();
    show_empty_stage();
  }
  on_.opening.loader.start(order_of(std::move(files)), stage_is_empty_);
}

void FileOpener::open_fresh() {
  if (const Status opened = open_default_scene(); !opened) on_.message.say(opened.error().message, true);
}

void FileOpener::open_left_work() {
  KERF_ASSERT(!on_.opening.left_work.empty());
  LoadOrder order = order_of({});
  order.left = on_.opening.left_work.front().journal;
  on_.opening.loader.start(std::move(order));
}

void FileOpener::take_loaded() {
  FileLoader& loader = on_.opening.loader;
  if (loader.busy()) {
    if (stage_is_empty_) {
      if (auto so_far = loader.take_so_far()) show_so_far(on_, std::move(*so_far));
    }
    const bool left = loader.order().left.has_value();
    KERF_ASSERT(!left || !on_.opening.left_work.empty());
    if (auto loaded = loader.take()) take(std::move(*loaded), left);
  }
  if (!stage_is_empty_ || loader.busy()) return;
  stage_is_empty_ = false;
  on_.so_far.reset();
  const std::string fault = on_.message.text;  // why there is nothing else
  open_fresh();
  if (!fault.empty()) on_.message.say(fault, true);
}

void FileOpener::take(Result<LoadedFiles> loaded, bool left) {
  const bool opened = loaded.ok();
  if (opened) {
    cancel_stroke(on_);
    show(std::move(*loaded));
  } else {
    on_.message.say((left ? "It stays where it is: " : "") + loaded.error().message, true);
  }
  if (left) {
    if (opened && recovery_.follow(on_.work, on_.view, false, on_.message))
      on_.opening.left_work.front().file.remove();
    on_.opening.left_work.clear();  // what else was left is offered the next time
  } else if (opened) {
    for (const std::filesystem::path& file : on_.work.files) remember_recent(on_.settings, file);
  }
}

}  // namespace kerf
