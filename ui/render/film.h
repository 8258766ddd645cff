#pragma once

#include "ui/render/studio.h"

namespace kerf {

struct FilmOptions {
  PictureOptions picture;
  double frames_per_second = 30;  // > 0
  std::filesystem::path folder;   // an existing folder, which receives frame-00000.png and so on
};

// Films the replay of a document as numbered PNGs at a pace of its own: the beam moves at a constant speed of
// one diagonal of the world in four seconds, measured at its emitter or in the middle of the world, whichever
// is faster. The film rests for half a second before the first stroke and after each stroke or other command,
// and for a second at the end.
class Film {
 public:
  // Writes the first frames, of a scene that is not cut yet. Fails like Studio::open, or if a frame cannot be
  // written.
  static Result<Film> begin(const Scene& scene, FilmOptions options);

  // To be called after each step of the document. `move` is the move of the beam, or nothing if the command
  // moves no beam; `step` is what the step changed, or null if that is unknown. Fails if a frame cannot be
  // written.
  Status follow(const Document& document, const std::optional<BeamMove>& move, const StepResult* step);
  // Writes the last frames.
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
