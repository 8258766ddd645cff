#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/result.h"

namespace kerf {

// A dimension line that is drawn over a figure.
struct Ruler {
  Vec3 from{0}, to{0};  // m, in the world
  std::string text;
};

// A figure, as a file describes it: what is drawn, and the line below it.
struct Figure {
  size_t number = 0;
  std::string caption;
  // One of these: a scene, a journal or a mesh; the recording of a match; a diagram by its name.
  std::filesystem::path scene, match;
  std::string diagram;
  size_t tick = 0;        // of the match
  double spread = 0;      // how far pieces are drawn apart, see spread_pieces()
  double mark_scale = 1;  // of numbers and lines in a picture 720 pixels high, see ViewOptions
  bool beam = false;      // the beam of the last stroke is drawn where it ended
  std::vector<Ruler> rulers;
};

// The files of the films, empty where there is none.
struct FigureFilms {
  std::filesystem::path cut;     // a journal, filmed as it is replayed
  std::filesystem::path fight;   // the recording of a match, of which the best moment is filmed
  std::filesystem::path graph;   // whose component graph is traversed
  std::filesystem::path shadow;  // a scene whose first light turns
};

// The content of a file of figures.
struct FigureList {
  std::vector<Figure> figures;
  FigureFilms films;
};

// Reads {"figures": [{"number": 1, "caption": "..", "scene": "figure-01.json", "spread": 0.3, "beam": true,
// "mark_scale": 2, "rulers": [{"from": [..], "to": [..], "text": ".."}]}, {.., "match": "figure-10.kerf",
// "tick": 1200}, {.., "diagram": "one-to-four"}], "films": {"cut": "film-cut.kerf", "fight": ..}}. Files are
// relative to the file. Bad input names the place of what is wrong.
Result<FigureList> read_figures(const std::filesystem::path& file);

}  // namespace kerf
