#include "ui/editor/work/file_opener.h"

#include "ui/editor/tools/viewport_input.h"
#include "ui/editor/work/open_file.h"

namespace kerf {

namespace {
constexpr double kPatience = 0.4;  // s, at the start, until the window shows something
}  // namespace

// What is read in a moment is there at once; what takes longer finds the default scene in its place.
Status FileOpener::open_first(std::filesystem::path default_scene,
                              const std::vector<std::filesystem::path>& files) {
  default_scene_ = std::move(default_scene);
  if (files.empty()) return open_default_scene();
  state_.loader.start(order_of(files));
  const bool soon = state_.loader.is_over(kPatience);
  if (soon) take_loaded();
  if (soon && !state_.files.empty()) return Done{};
  const std::string fault = std::exchange(state_.message, {});
  const Status opened = open_default_scene();
  if (opened && !fault.empty()) state_.say(fault, true);
  return opened;
}

LoadOrder FileOpener::order_of(std::vector<std::filesystem::path> files) const {
  return {std::move(files), {}, state_.settings.history_bytes()};
}

Status FileOpener::open_default_scene() {
  Result<LoadedFiles> loaded = load_files(order_of({default_scene_}), nullptr);
  if (!loaded) return loaded.error();
  show(std::move(*loaded));
  return Done{};
}

// What was open until then is kept no longer.
void FileOpener::show(LoadedFiles loaded) {
  show_loaded(state_, renderer_, std::move(loaded));
  keeper_.drop();
  keeper_.begin(state_);
}

void FileOpener::open(const Requests& wanted) {
  if (!wanted.fresh) {
    state_.loader.start(order_of(wanted.open));
  } else if (const Status opened = open_default_scene(); !opened) {
    state_.say(opened.error().message, true);
  }
}

void FileOpener::open_left_work() {
  LoadOrder order = order_of({});
  order.left = state_.left_work.front().journal;
  state_.loader.start(std::move(order));
}

void FileOpener::take_loaded() {
  if (!state_.loader.busy()) return;
  const bool left = state_.loader.order().left.has_value();
  std::optional<Result<LoadedFiles>> loaded = state_.loader.take();
  if (!loaded) return;
  const bool opened = loaded->ok();
  if (opened) {
    cancel_stroke(state_);
    show(std::move(**loaded));
  } else {
    state_.say((left ? "It stays where it is: " : "") + loaded->error().message, true);
  }
  if (left) {
    if (opened && keeper_.follow(state_)) state_.left_work.front().file.remove();
    state_.left_work.clear();  // what else was left is offered the next time
  } else if (opened) {
    for (const std::filesystem::path& file : state_.files) remember_recent(state_.settings, file);
  }
}

}  // namespace kerf
