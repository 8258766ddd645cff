#pragma once

#include <optional>

#include "core/game/match/match.h"
#include "ui/game/game_settings.h"
#include "ui/game/match_graph.h"
#include "ui/game/scorches.h"
#include "ui/gl/framebuffer.h"
#include "ui/render/renderer.h"
#include "ui/screen/particles.h"

namespace kerf {

// Chooses the preset of the pictures by how long they take: it goes down where that is too slow, at once to
// the lowest where it is far too slow.
class PresetChoice {
 public:
  // `software`: pictures are computed by the processor, which can do only the lowest in time.
  explicit PresetChoice(bool software) : best_(software ? PicturePreset::kLow : PicturePreset::kHigh) {}

  // What is drawn for a setting: itself, unless it is kAutomatic.
  PicturePreset choose(PicturePreset setting) const;
  // The last picture took a time (s).
  void took(double seconds);

 private:
  PicturePreset best_;
  int slow_ = 0, seen_ = 0;  // pictures with this preset
};

// Chooses the resolution of pictures with the lowest preset, as a share of that of the window in each
// direction: lower where they take too long, higher where there is time left.
class ResolutionChoice {
 public:
  static constexpr double kLeast = 0.5, kFirst = 0.7;
  double share() const { return share_; }
  // The last picture took a time (s).
  void took(double seconds);

 private:
  double share_ = kFirst;
  int slow_ = 0, fast_ = 0;  // pictures, one after the other
};

// Whether the current OpenGL context draws without a graphics card.
bool draws_in_software();

// The picture of a match: its world by night under floodlights, with the beams of all lasers and with what
// they throw off.
class MatchPicture {
 public:
  // Fails if a shader is missing or does not compile.
  static Result<MatchPicture> create();

  // Shows the world of a match from now on.
  void show(const Match& match);
  // Follows what the last tick changed; shows the match anew where a wave began, which brings other vehicles.
  // To be called after every tick.
  void follow(const Match& match);
  // Lets time pass (s) for sparks and smoke.
  void advance(const Match& match, double seconds);

  // Draws a picture. `preset` is not kAutomatic; with kLow `share` is that of a ResolutionChoice.
  void draw(const Match& match, const CameraView& view, const Target& target, PicturePreset preset,
            double share = 1);

  // The switches of the debug views.
  ViewOptions& look() { return look_; }
  const Renderer& renderer() const { return renderer_; }

 private:
  explicit MatchPicture(Renderer renderer) : renderer_(std::move(renderer)) {}
  void dress(const Match& match, PicturePreset preset);

  Renderer renderer_;
  ViewOptions look_;
  Particles particles_;
  Scorches scorches_;
  MatchGraph graph_;
  std::optional<gl::Framebuffer> small_;  // a picture of a lower resolution
};

}  // namespace kerf
