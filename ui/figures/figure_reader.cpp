#include "core/game/json_fields.h"
#include "ui/figures/figure.h"

namespace kerf {

namespace {

Status parse_ruler(const JsonValue& value, std::vector<Ruler>& rulers) {
  Ruler ruler;
  JsonFields fields(value);
  fields.vector("from", ruler.from, true).vector("to", ruler.to, true).text("text", ruler.text, true);
  rulers.push_back(std::move(ruler));
  return fields.status();
}

Status parse_figure(const JsonValue& value, const std::filesystem::path& folder,
                    std::vector<Figure>& figures) {
  Figure figure;
  std::string scene, match;
  JsonFields fields(value);
  fields.count("number", figure.number, 1, 99, true).text("caption", figure.caption, true);
  fields.text("scene", scene).text("match", match).text("diagram", figure.diagram);
  fields.count("tick", figure.tick, 0, 10'000'000).number("spread", figure.spread, {0, 100});
  fields.number("mark_scale", figure.mark_scale, {0.1, 10});
  fields.flag("beam", figure.beam);
  fields.list("rulers", "rulers", [&](const JsonValue& ruler) { return parse_ruler(ruler, figure.rulers); });
  if (!fields.status()) return fields.status();
  if (scene.empty() + match.empty() + figure.diagram.empty() != 2)
    return value.wrong("must have one of \"scene\", \"match\" and \"diagram\"");
  if (!figure.diagram.empty() && figure.diagram != "one-to-four")
    return value["diagram"].wrong("must be \"one-to-four\"");
  if (!scene.empty()) figure.scene = folder / scene;
  if (!match.empty()) figure.match = folder / match;
  figures.push_back(std::move(figure));
  return Done{};
}

Status parse_films(const JsonValue& value, const std::filesystem::path& folder, FigureFilms& films) {
  JsonFields fields(value);
  for (const auto& [key, film] : {std::pair{"cut", &films.cut},
                                  {"fight", &films.fight},
                                  {"graph", &films.graph},
                                  {"shadow", &films.shadow}}) {
    std::string name;
    fields.text(key, name);
    if (!name.empty()) *film = folder / name;
  }
  return fields.status();
}

}  // namespace

Result<FigureList> read_figures(const std::filesystem::path& file) {
  const auto text = read_text_file(file);
  if (!text) return text.error();
  const auto json = parse_json(*text, file.string());
  if (!json) return json.error();
  FigureList list;
  const std::filesystem::path folder = file.parent_path();
  JsonFields fields(JsonValue(*json, file.string()));
  fields.list(
      "figures", "figures",
      [&](const JsonValue& figure) { return parse_figure(figure, folder, list.figures); }, true);
  fields.member("films", [&](const JsonValue& films) { return parse_films(films, folder, list.films); });
  if (!fields.status()) return fields.status().error();
  return list;
}

}  // namespace kerf
