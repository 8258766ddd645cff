#pragma once

#include "ui/render/studio.h"

namespace kerf {

struct FilmOptions {
  PictureOptions picture;
  double frames_per_second = 30;  // > 0
  std::filesystem::path folder;   // is there; frame-00000.png and so on are written to it
};

// Films what happens to a document, in numbered PNGs. A journal holds no times, so the film has a pace of its
// own: the beam goes at a steady speed that takes it across the diagonal of the world in four seconds,
// measured at its emitter or in the middle of the world, whichever goes faster; the film rests for half a
// second before the first stroke and after each stroke and other command, and for a second at the end.
class Film {
 public:
  // Takes the first frames of a scene that is not cut yet. Fails as Studio::open does, and where a frame
  // cannot be written.
  static Result<Film> begin(const Scene& scene, FilmOptions options);

  // After each step of the document: the one move that it walked, none where the command moves no beam, and
  // what it changed, null where that is not known.
  Status follow(const Document& document, const std::optional<BeamMove>& move, const StepResult* step);
  Status end(const Document& document);

 private:
  Film(Studio studio, FilmOptions options, const World::Bounds& bounds);
  double seconds_of(const BeamMove& move) const;
  std::optional<BeamPicture> beam_picture(const Document& document, const Pose& beam) const;
  Status pass(double seconds, const World& world, const std::optional<BeamPicture>& beam);

  Studio studio_;
  FilmOptions options_;
  Vec3 middle_;
  double speed_;  // m/s
  double clock_ = 0;
  size_t frames_ = 0;
};

}  // namespace kerf
