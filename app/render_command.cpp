#include <CLI/CLI.hpp>

#include "app/commands.h"
#include "app/exit_status.h"
#include "app/interrupt.h"
#include "app/parse_values.h"
#include "app/progress_line.h"
#include "ui/render/picture.h"

namespace kerf {

namespace {

struct RenderArguments {
  std::string file, out, size = "1280x720", eye, target, show;
};

Result<Scene> load_scene(const std::filesystem::path& file) {
  ProgressLine line("loading " + file.filename().string());
  const Progress progress = line.progress();
  return read_scene(file, &progress);
}

Status render(const RenderArguments& a) {
  PictureOptions options;
  const auto size = parse_size(a.size);
  if (!size) return size.error();
  options.width = size->width;
  options.height = size->height;
  if (!a.eye.empty()) {
    const auto eye = parse_point("--eye", a.eye);
    if (!eye) return eye.error();
    options.eye = *eye;
  }
  if (!a.target.empty()) {
    const auto target = parse_point("--target", a.target);
    if (!target) return target.error();
    options.target = *target;
  }
  const auto show = parse_show_list(a.show);
  if (!show) return show.error();
  options.show = *show;
  catch_interrupts();
  Result<Scene> scene = load_scene(a.file);
  if (!scene) return error_or_stopped(scene.error());
  let_interrupts_end();
  if (a.show.empty()) {
    const auto wanted = parse_show_list(scene->show);
    if (!wanted) return bad_input(a.file + ": /show: " + wanted.error().message);
    options.show = *wanted;
  }
  return render_picture(std::move(*scene), options, a.out);
}

}  // namespace

void add_render_command(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("render", "Draw a scene or a mesh to a PNG, without a display");
  auto a = std::make_shared<RenderArguments>();
  command->add_option("FILE", a->file, "A scene (.json) or a mesh")->required();
  command->add_option("--out", a->out, "The PNG to write")->required();
  command->add_option("--size", a->size, "Width and height in pixels, WxH (1280x720)");
  command->add_option("--eye", a->eye, "Where the camera stands, x,y,z in metres");
  command->add_option("--target", a->target, "What it looks at, x,y,z in metres");
  command->add_option("--show", a->show, "Overlays, separated by commas: " + offered_show_names());
  command->callback([a, &action] {
    action = [a] {
      const Status status = render(*a);
      return status ? 0 : report_error(status.error());
    };
  });
}

}  // namespace kerf
