#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/parallel.h"
#include "ui/figures/figure.h"

namespace kerf {

// A triangle of a diagram of the 1-to-4 split, in the plane.
struct DiagramTriangle {
  std::array<Vec2, 3> corners;
  bool hit = false;  // the beam intersects it
  bool removed = false;
  // midpoint of the edge opposite `corner`, if the closure bisects the triangle
  std::optional<Vec2> bisected;
  size_t corner = 0;  // the corner that the bisection starts from
};

// Returns the stages in which the paper's scheme cuts an equilateral triangle with a beam: the triangle;
// its four parts; the parts of the hit triangles; and the remainder without the hit triangles. Uses
// OneToFour, so the neighbours of split parts are closed as in every mesh.
std::vector<std::vector<DiagramTriangle>> split_stages(const Vec2& beam, double radius);

std::array<Vec2, 3> diagram_triangle();

// Draws the stages side by side with the current ImGui context, over the whole image.
void draw_split_diagram();

// The output of a film: images named frame-00000.png and so on in an existing folder.
struct FilmFormat {
  std::filesystem::path folder;
  int width = 1280, height = 720;
  double frames_per_second = 30;  // > 0
};

// These functions write one film each, without a window, and remove the images of an earlier, longer one from
// the folder. They fail if a file cannot be read, an image cannot be written or removed or OpenGL is not
// available, and with cancelled() if `progress` stops them.

// Films the replay of a journal in the time of its world.
Status film_cut(const std::filesystem::path& journal, const FilmFormat& format, const Progress& progress);
// Films the best moment of a recorded match (see ScoreLog) from an outside view, replayed by the current
// rules.
Status film_fight(const std::filesystem::path& recording, const FilmFormat& format, const Progress& progress);
// Films the traversal of the component graph of the final world of a journal or a scene.
Status film_graph(const std::filesystem::path& work, const FilmFormat& format, const Progress& progress);
// Films a scene while its first light makes one turn about the vertical axis.
Status film_shadow(const std::filesystem::path& scene, const FilmFormat& format, const Progress& progress);

struct FigureSize {
  int width = 1280, height = 720;  // pixels, with the caption; >= 64
};

// Draws a figure with its caption below, without a window, and writes it as a PNG atomically. The output is
// byte-identical on one machine. Fails if one of its files cannot be read, OpenGL is not available, or the
// PNG cannot be written.
Status draw_figure(const Figure& figure, const FigureSize& size, const std::filesystem::path& png);

}  // namespace kerf
