
#include <cstdio>

#include "app/arguments.h"
#include "app/console.h"
#include "app/cut_output.h"
#include "core/base/platform.h"
#include "ui/figures/draw_figure.h"
#include "ui/render/view/view_options.h"

namespace kerf {

namespace {

struct RenderArguments {
  std::string file, out, unit = "m";
  double spread = 0;
  PictureArguments picture;
};

Status render(const RenderArguments& a) {
  if (const auto s = check_picture_name("--out", a.out); !s) return s;
  auto options = a.picture.parse();
  if (!options) return options.error();
  options->spread = a.spread;
  const auto unit = parse_unit(a.unit);
  if (!unit) return unit.error();
  catch_interrupts();
  Result<OpenedFile> work = load_file(a.file, *unit);
  if (!work) return work.error();
  if (const auto s = inputs_of(a.file, *work).check("--out", a.out); !s) return s;
  end_on_interrupt();
  if (const auto s = show_as_asked(a.picture, work->scene, a.file, *options); !s) return s;
  return render_picture(std::move(*work), *options, a.out);
}

struct FiguresArguments {
  std::string out, film, list, size = "1280x720";
};

constexpr int kMinSide = 64;

Status make_figures(const FiguresArguments& a, const std::vector<Figure>& figures, const PixelSize& size) {
  if (const Status made = PiecesFolder{a.out}.make(); !made) return made;
  ProgressLine line("drawing the figures");
  for (size_t i = 0; i < figures.size(); ++i) {
    if (interrupted()) return stopped();
    line.update(static_cast<double>(i) / static_cast<double>(figures.size()));
    char name[16];
    std::snprintf(name, sizeof name, "fig%02zu.png", figures[i].number);
    const Status drawn =
        draw_figure(figures[i], {size.width, size.height}, std::filesystem::path(a.out) / name);
    if (!drawn) return drawn;
  }
  return Done{};
}

using MakeFilm = Status(const std::filesystem::path& file, const FilmFormat& format,
                        const Progress& progress);

Status make_film(const std::filesystem::path& frames, const std::filesystem::path& file,
                 const PixelSize& size, MakeFilm* film) {
  if (file.empty()) return Done{};
  if (const Status made = PiecesFolder{frames.string()}.make(); !made) return made;
  ProgressLine line("filming " + file.filename().string());
  const Status filmed = film(file, {frames, size.width, size.height}, line.progress());
  return filmed ? filmed : Status(error_or_stopped(filmed.error()));
}

Status make_films(const std::filesystem::path& folder, const FigureFilms& films, const PixelSize& size) {
  if (const Status made = make_film(folder / "cut", films.cut, size, film_cut); !made) return made;
  if (const Status made = make_film(folder / "fight", films.fight, size, film_fight); !made) return made;
  if (const Status made = make_film(folder / "graph", films.graph, size, film_graph); !made) return made;
  return make_film(folder / "shadow", films.shadow, size, film_shadow);
}

Status check_outputs(const FiguresArguments& a, const std::filesystem::path& list_file,
                     const FigureList& list) {
  std::vector<std::string> read{list_file.string()};
  for (const Figure& figure : list.figures) {
    for (const std::filesystem::path& file : {figure.scene, figure.match}) read.push_back(file.string());
  }
  for (const std::filesystem::path& file :
       {list.films.cut, list.films.fight, list.films.graph, list.films.shadow})
    read.push_back(file.string());
  std::erase(read, "");
  const InputFiles inputs = inputs_of(read);
  if (!a.out.empty()) {
    const auto is_figure = [](std::string_view name) {
      return name.starts_with("fig") && name.ends_with(".png");
    };
    if (const Status free = inputs.check_folder("--out", a.out, is_figure); !free) return free;
  }
  if (a.film.empty()) return Done{};
  for (const char* const film : {"cut", "fight", "graph", "shadow"}) {
    if (const Status free = check_frames("--film", std::filesystem::path(a.film) / film, inputs); !free)
      return free;
  }
  return Done{};
}

Status run(const FiguresArguments& a) {
  if (a.out.empty() && a.film.empty())
    return bad_input("--out or --film: name a folder for the figures or for the films");
  const auto size = parse_size(a.size);
  if (!size) return size.error();
  if (std::min(size->width, size->height) < kMinSide)
    return bad_input("--size: a figure with its caption needs at least 64x64 pixels");
  const std::filesystem::path own = assets_folder() / "figures.json";
  const std::filesystem::path file = a.list.empty() ? own : std::filesystem::path(a.list);
  const auto list = read_figures(file);
  if (!list) return list.error();
  if (const Status free = check_outputs(a, file, *list); !free) return free;
  catch_interrupts();
  if (!a.out.empty()) {
    if (const Status made = make_figures(a, list->figures, *size); !made) return made;
  }
  return a.film.empty() ? Status(Done{}) : make_films(a.film, list->films, *size);
}

}  // namespace

void add_render_command(CLI::App& app, Invocation& invocation) {
  CLI::App* command =
      app.add_subcommand("render", "Draw a scene, a journal or a mesh to a PNG, without a display");
  auto a = std::make_shared<RenderArguments>();
  command->add_option("FILE", a->file, "A scene (.json), a journal (.kerf) or a mesh")->required();
  command->add_option("-o,--out", a->out, "The PNG to write")->required();
  add_unit_option(*command, a->unit);
  a->picture.add_to(*command);
  add_number(*command, "--spread", a->spread, kSpread,
             "Explode the pieces by this factor of their distance from the centre (0)");
  on_call(
      *command, invocation, [a] { return render(*a); },
      "kerf render assets/scenes/sphere.json --out ball.png --size 640x360");
}

void add_figures_command(CLI::App& app, Invocation& invocation) {
  CLI::App* command = app.add_subcommand(
      "figures", "Draw the figures of the paper as fig01.png and so on, without a display");
  auto a = std::make_shared<FiguresArguments>();
  command->add_option("-o,--out", a->out, "The folder for the figures");
  command->add_option(
      "--film", a->film,
      "A folder for the films: the car cut in two, a fight, the traversal of the graph and the "
      "shadow volume, each as numbered images in its own folder");
  command->add_option("--size", a->size,
                      "Size of each image, for figures including the caption, WxH (1280x720)");
  command->add_option("--list", a->list, "A file (.json) that describes the figures (assets/figures.json)");
  on_call(
      *command, invocation, [a] { return run(*a); }, "kerf figures --out figures --size 160x95");
}

}  // namespace kerf
