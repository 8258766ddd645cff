#include "app/commands.h"
#include "app/load.h"
#include "app/parse_values.h"
#include "app/picture_arguments.h"
#include "ui/render/view/spread.h"

namespace kerf {

namespace {

struct RenderArguments {
  std::string file, out;
  double spread = 0;
  PictureArguments picture;
};

Status render(const RenderArguments& a) {
  if (const auto s = check_picture_name("--out", a.out); !s) return s;
  auto options = a.picture.parse();
  if (!options) return options.error();
  options->spread = a.spread;
  catch_interrupts();
  Result<OpenedFile> work = load_file(a.file);
  if (!work) return work.error();
  if (const auto s = inputs_of(a.file, *work).check("--out", a.out); !s) return s;
  let_interrupts_end();
  if (const auto s = show_as_asked(a.picture, work->scene, a.file, *options); !s) return s;
  return render_picture(std::move(*work), *options, a.out);
}

}  // namespace

void add_render_command(CLI::App& app, Invocation& invocation) {
  CLI::App* command =
      app.add_subcommand("render", "Draw a scene, a journal or a mesh to a PNG, without a display");
  auto a = std::make_shared<RenderArguments>();
  command->add_option("FILE", a->file, "A scene (.json), a journal (.kerf) or a mesh")->required();
  command->add_option("--out", a->out, "The PNG to write")->required();
  a->picture.add_to(*command);
  add_number(*command, "--spread", a->spread, kSpread,
             "How far the pieces are drawn apart, in distances from the middle (0)");
  on_call(
      *command, invocation, [a] { return render(*a); },
      "kerf render assets/scenes/sphere.json --out ball.png --size 640x360");
}

}  // namespace kerf
