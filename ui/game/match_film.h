#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "core/game/match/match.h"
#include "ui/game/game_camera.h"

namespace kerf {

// A film of a match as numbered pictures (frame-00000.png and so on), seen from behind the player's vehicle,
// without a screen. Its OpenGL context is current while it exists.
class MatchFilm {
 public:
  struct Options {
    std::filesystem::path folder;  // exists
    int width = 1280, height = 720;
    double frames_per_second = 30;    // > 0
    std::optional<Vec3> eye, target;  // m; a camera that stands still, if both are given
  };

  // Fails if OpenGL is not available or does not support the size.
  static Result<MatchFilm> begin(const Match& match, const Options& options);
  ~MatchFilm();
  MatchFilm(MatchFilm&&) noexcept;

  // To be called after each tick, with the controls that the player had in it. Writes the pictures that are
  // due. Fails if one cannot be written.
  Status follow(const Match& match, const Controls& controls);

 private:
  struct Parts;
  explicit MatchFilm(std::unique_ptr<Parts> parts);
  Status take_picture(const Match& match);

  std::unique_ptr<Parts> parts_;
};

}  // namespace kerf
