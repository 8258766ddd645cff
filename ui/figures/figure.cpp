#include "ui/figures/figure.h"
#include "core/document/text/fields.h"
#include "ui/render/view/view_options.h"

namespace kerf {

static void describe(Fields& f, Ruler& ruler) {
  f.vector("from", ruler.from, VectorRule::kNearby);
  f.vector("to", ruler.to, VectorRule::kNearby);
  f.filled_text("text", ruler.text);
}

static void describe(Fields& f, Figure& figure) {
  f.whole("number", figure.number, 1, 99);
  f.filled_text("caption", figure.caption);
  f.path("scene", figure.scene, kOptional);
  f.path("match", figure.match, kOptional);
  f.filled_text("diagram", figure.diagram, kOptional);
  f.check(figure.scene.empty() + figure.match.empty() + figure.diagram.empty() == 2, nullptr,
          "must have one of \"scene\", \"match\" and \"diagram\"");
  f.check(figure.diagram.empty() || figure.diagram == "one-to-four", "diagram", "must be \"one-to-four\"");
  f.whole("tick", figure.tick, 0, 10'000'000, kOptional);
  f.number("spread", figure.spread, kSpread, kOptional);
  f.number("mark_scale", figure.mark_scale, {0.1, 10}, kOptional);
  f.flag("beam", figure.beam, kOptional);
  f.list("rulers", "rulers", figure.rulers, kOptional);
}

static void describe(Fields& f, FigureFilms& films) {
  f.path("cut", films.cut, kOptional);
  f.path("fight", films.fight, kOptional);
  f.path("graph", films.graph, kOptional);
  f.path("shadow", films.shadow, kOptional);
}

static void describe(Fields& f, FigureList& list) {
  f.list("figures", "figures", list.figures);
  f.object("films", list.films, kOptional);
}

Result<FigureList> read_figures(const std::filesystem::path& file) {
  return read_described<FigureList>(file);
}

}  // namespace kerf
