#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/result.h"

namespace kerf {

struct Ruler {
  Vec3 from{0}, to{0};  // m, in the world
  std::string text;
};

// A figure as its file describes it: the content and the caption.
struct Figure {
  size_t number = 0;
  std::string caption;
  // Exactly one of these is set: a scene, a journal or a mesh; the recording of a match; the name of a
  // diagram.
  std::filesystem::path scene, match;
  std::string diagram;
  size_t tick = 0;        // of the match
  double spread = 0;      // factor of the exploded view, see spread_pieces()
  double mark_scale = 1;  // of numbers and lines in an image 720 pixels high, see ViewOptions
  bool beam = false;      // draws the beam of the last stroke at its end
  std::vector<Ruler> rulers;
};

// The files of the films; an empty path: no such film.
struct FigureFilms {
  std::filesystem::path cut;     // a journal, filmed during its replay
  std::filesystem::path fight;   // the recording of a match; its best moment is filmed
  std::filesystem::path graph;   // a journal or scene; its component graph is traversed
  std::filesystem::path shadow;  // a scene whose first light rotates
};

struct FigureList {
  std::vector<Figure> figures;
  FigureFilms films;
};

// Reads {"figures": [{"number": 1, "caption": "..", "scene": "figure-01.json", "spread": 0.3, "beam": true,
// "mark_scale": 2, "rulers": [{"from": [..], "to": [..], "text": ".."}]}, {.., "match": "figure-10.kerf",
// "tick": 1200}, {.., "diagram": "one-to-four"}], "films": {"cut": "film-cut.kerf", "fight": ..}}. Paths
// are relative to the file. The error for bad input names the faulty field.
Result<FigureList> read_figures(const std::filesystem::path& file);

}  // namespace kerf
