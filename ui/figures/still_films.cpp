#include <algorithm>
#include <cmath>

#include "core/base/angle.h"
#include "core/base/assert.h"
#include "core/document/history/last_cut_graph.h"
#include "core/document/journal/opened_file.h"
#include "ui/figures/figure_films.h"
#include "ui/render/picture/png.h"
#include "ui/render/picture/studio.h"

namespace kerf {

namespace {

constexpr double kTraversal = 6, kAfterTraversal = 1.5;  // s
constexpr double kTurnOfLight = 8;                       // s

// Films a world in which nothing moves. `draw` is called with the share of the film that has passed, 0 to 1.
Status film_still(const FilmFormat& format, double seconds, const Progress& progress, const Studio& studio,
                  const std::function<void(double)>& draw) {
  KERF_ASSERT(format.frames_per_second > 0);
  const auto frames = static_cast<size_t>(std::lround(seconds * format.frames_per_second));
  for (size_t i = 0; i < frames; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(frames);
    if (!progress.report(share)) return cancelled();
    draw(share);
    if (const Status written = studio.write(frame_file(format.folder, i)); !written) return written;
  }
  return Done{};
}

Result<DrawnPicture> draw_first(const std::filesystem::path& file, const FilmFormat& format) {
  auto work = open_file(file);
  if (!work) return work.error();
  const auto options = options_for(file, work->scene, format.width, format.height);
  if (!options) return options.error();
  return draw_picture(std::move(*work), *options);
}

}  // namespace

Status film_graph(const std::filesystem::path& work, const FilmFormat& format, const Progress& progress) {
  const auto picture = draw_first(work, format);
  if (!picture) return picture.error();
  const auto whole = graph_around_last_cut(*picture->document);
  if (!whole) return bad_input(work.string() + ": no face is left, so there is no graph to film");
  Studio& studio = *picture->studio;
  return film_still(format, kTraversal + kAfterTraversal, progress, studio, [&](double share) {
    const double done = std::min(1.0, share * (kTraversal + kAfterTraversal) / kTraversal);
    auto drawn = std::make_shared<DrawnGraph>(*whole);
    drawn->marked = static_cast<size_t>(std::lround(done * static_cast<double>(whole->reached)));
    studio.look().graph = std::move(drawn);
    studio.draw(picture->document->world(), std::nullopt);
  });
}

Status film_shadow(const std::filesystem::path& scene, const FilmFormat& format, const Progress& progress) {
  const auto picture = draw_first(scene, format);
  if (!picture) return picture.error();
  Studio& studio = *picture->studio;
  KERF_ASSERT(!studio.look().lights.empty());
  const Vec3 first = studio.look().lights[0].at;
  return film_still(format, kTurnOfLight, progress, studio, [&](double share) {
    studio.look().lights[0].at = turn_about({0, 1, 0}, share * 2 * kPi) * first;
    studio.draw(picture->document->world(), std::nullopt);
  });
}

}  // namespace kerf
