#pragma once

#include "core/base/parallel.h"
#include "ui/figures/figure.h"

namespace kerf {

// How films are made: pictures named frame-00000.png and so on in an existing folder.
struct FilmFormat {
  std::filesystem::path folder;
  int width = 1280, height = 720;
  double frames_per_second = 30;  // > 0
};

// Each makes one film without a screen. They fail if a file cannot be read, a picture cannot be written or
// OpenGL is not available, and with cancelled() when `progress` stops them.

// A journal as it is replayed, in the time of its world.
Status film_cut(const std::filesystem::path& journal, const FilmFormat& format, const Progress& progress);
// The best moment of a recorded match (see ScoreLog) from outside, played by the rules as they are.
Status film_fight(const std::filesystem::path& recording, const FilmFormat& format, const Progress& progress);
// The traversal of the component graph of what a journal or a scene ends with.
Status film_graph(const std::filesystem::path& work, const FilmFormat& format, const Progress& progress);
// A scene while its first light turns around the vertical axis once.
Status film_shadow(const std::filesystem::path& scene, const FilmFormat& format, const Progress& progress);

}  // namespace kerf
