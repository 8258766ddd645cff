#pragma once

#include <filesystem>
#include <optional>

#include "ui/game/game_camera.h"
#include "ui/game/match_picture.h"
#include "ui/gl/offscreen_context.h"

namespace kerf {

// Draws matches as numbered pictures (frame-00000.png and so on) in a folder, without a screen. The OpenGL
// context is current while this exists.
struct MatchFrames {
  gl::OffscreenContext context;
  MatchPicture picture;
  gl::Framebuffer frame;
  std::filesystem::path folder;
  size_t taken = 0;

  // Fails if OpenGL is not available or does not support the size. Precondition: the folder exists.
  static Result<MatchFrames> open(const std::filesystem::path& folder, int width, int height);
  double aspect() const { return static_cast<double>(frame.shape().width) / frame.shape().height; }
  // Draws and writes the next picture. Fails if it cannot be written.
  Status take(const Match& match, const CameraView& view);
};

// A film of a match, seen from behind the player's vehicle.
class MatchFilm {
 public:
  struct Options {
    std::filesystem::path folder;  // exists
    int width = 1280, height = 720;
    double frames_per_second = 30;    // > 0
    std::optional<Vec3> eye, target;  // m; a camera that stands still, if both are given
  };

  // Fails like MatchFrames::open.
  static Result<MatchFilm> begin(const Match& match, const Options& options);

  // To be called after each tick, with the controls that the player had in it. Writes the pictures that are
  // due. Fails if one cannot be written.
  Status follow(const Match& match, const Controls& controls);

 private:
  MatchFilm(MatchFrames frames, const Options& options);

  MatchFrames frames_;
  Options options_;
  GameCamera camera_;
};

}  // namespace kerf
