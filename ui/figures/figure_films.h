#pragma once

#include "core/base/parallel.h"
#include "ui/figures/figure.h"

namespace kerf {

// The output of a film: images named frame-00000.png and so on in an existing folder.
struct FilmFormat {
  std::filesystem::path folder;
  int width = 1280, height = 720;
  double frames_per_second = 30;  // > 0
};

// These functions write one film each, without a window. They fail if a file cannot be read, an image
// cannot be written or OpenGL is not available, and with cancelled() if `progress` stops them.

// Films the replay of a journal in the time of its world.
Status film_cut(const std::filesystem::path& journal, const FilmFormat& format, const Progress& progress);
// Films the best moment of a recorded match (see ScoreLog) from an outside view, replayed by the current
// rules.
Status film_fight(const std::filesystem::path& recording, const FilmFormat& format, const Progress& progress);
// Films the traversal of the component graph of the final world of a journal or a scene.
Status film_graph(const std::filesystem::path& work, const FilmFormat& format, const Progress& progress);
// Films a scene while its first light makes one turn about the vertical axis.
Status film_shadow(const std::filesystem::path& scene, const FilmFormat& format, const Progress& progress);

}  // namespace kerf
