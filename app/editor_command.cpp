#include "app/commands.h"
#include "app/load.h"
#include "app/parse_values.h"
#include "core/base/assets.h"
#include "ui/editor/editor.h"

namespace kerf {

namespace {

struct EditorArguments {
  std::vector<std::string> files;
  std::string report, size, landmarks, events;
  bool own_font = false;
};

Status edit(const EditorArguments& a) {
  EditorOptions options;
  options.default_scene = assets_folder() / "scenes" / "car.json";
  for (const std::string& file : a.files) {
    if (!std::filesystem::exists(file)) {
      return bad_input(file + ": there is no such file, and this version has no such command");
    }
    options.files.emplace_back(file);
  }
  for (const auto& [option, file] : {std::pair{"--report", a.report}, {"--landmarks", a.landmarks}}) {
    if (file.empty()) continue;
    if (const Status free = inputs_of(a.files).check(option, file); !free) return free;
  }
  if (!a.report.empty()) options.report = a.report;
  if (!a.landmarks.empty()) options.landmarks = a.landmarks;
  if (!a.events.empty()) options.events = a.events;
  options.own_font = a.own_font;
  if (!a.size.empty()) {
    const auto size = parse_size(a.size);
    if (!size) return size.error();
    options.width = size->width;
    options.height = size->height;
  }
  return run_editor(options);
}

}  // namespace

void add_editor(CLI::App& app, Invocation& invocation) {
  auto a = std::make_shared<EditorArguments>();
  app.add_option("FILE", a->files,
                 "Scenes (.json) and meshes to open together in the editor, or a journal (.kerf)");
  app.add_option("--report", a->report, "Where the editor writes what happened, as JSON, when it ends");
  app.add_option("--size", a->size, "Size of the editor's window, WxH");
  constexpr auto kHidden = "";  // from the help: these are for the tests of the window
  app.add_option("--landmarks", a->landmarks, "Where the editor keeps the places of its widgets, as JSON")
      ->group(kHidden);
  app.add_option("--events", a->events, "A script of input that drives the editor without a screen")
      ->group(kHidden);
  app.add_flag("--own-font", a->own_font, "Draw the panels as where no font is installed")->group(kHidden);
  invocation = [a] { return edit(*a); };
}

}  // namespace kerf
