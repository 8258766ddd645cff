#pragma once

#include <algorithm>
#include <atomic>
#include <deque>
#include <filesystem>
#include <future>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/assert.h"
#include "core/base/ids.h"
#include "core/game/match/match.h"
#include "core/game/match/recording.h"
#include "core/graph/drawn_graph.h"
#include "ui/game/game_camera.h"
#include "ui/game/game_settings.h"
#include "ui/gl/buffers.h"
#include "ui/gl/context.h"
#include "ui/render/passes/beam_effects.h"
#include "ui/render/renderer.h"

namespace kerf {

// Computes the number of ticks that a frame has to advance, at most kMaxTicks: if the machine is too slow,
// the match runs in slow motion.
class MatchClock {
 public:
  static constexpr int kMaxTicks = 8;

  // Returns the ticks that are due after a frame of a duration [s], >= 0.
  int advance(double seconds);
  // Runs the match at a quarter of its speed for some time [s] of the player at least.
  void slow_down(double seconds) { slow_s_ = std::max(slow_s_, seconds); }
  // Stops the match for some time [s] of the player.
  void stop(double seconds) { stopped_s_ = std::max(stopped_s_, seconds); }
  // Sets the speed of the match relative to real time, > 0.
  void set_pace(double pace) { pace_ = pace; }
  bool is_slow() const { return slow_s_ > 0; }
  // The speed of the match now, relative to real time.
  double pace() const;
  double slow_left() const { return slow_s_; }  // s
  // Due ticks that the last advance() dropped.
  int dropped() const { return dropped_; }
  // The fraction of due ticks not dropped in about the last second; below 1 the machine is too slow.
  double speed() const { return speed_; }

 private:
  double owed_ = 0;    // ticks, below 1
  double slow_s_ = 0;  // left of the slow motion
  double stopped_s_ = 0;
  double pace_ = 1;
  int dropped_ = 0;
  double speed_ = 1;
};

// The replay of a moment of a match. A thread simulates the wave up to the beginning of the moment,
// concurrently with the frames.
class MatchReplay {
 public:
  // `controls` are those of the whole match. Precondition: they extend to the end of the moment.
  MatchReplay(const MatchSetup& setup, const MatchMoment& moment, std::vector<Controls> controls);
  ~MatchReplay();
  MatchReplay(const MatchReplay&) = delete;
  MatchReplay& operator=(const MatchReplay&) = delete;

  enum class State { kPreparing, kPlaying, kOver };
  // Returns the state, after a check whether the preparation is finished. Does not wait.
  State state();

  // The match at the current tick of the replay. Precondition of this and the following functions: state()
  // is not kPreparing.
  const Match& match() const {
    KERF_ASSERT(match_ != nullptr);
    return *match_;
  }
  const ReplayCamera& camera() const { return camera_; }
  // Returns the ticks that are due after a frame of a duration [s]; in slow motion while a vehicle is cut
  // in two.
  int due(double seconds);
  bool is_slow() const { return clock_.is_slow(); }
  // Advances by a tick. No-op once it is over.
  void tick();
  // Ends it: state() returns kOver from now on.
  void skip() { skipped_ = true; }
  bool is_skipped() const { return skipped_; }
  void move_camera(double seconds) { camera_.follow(*match_, seconds); }

 private:
  std::vector<Controls> controls_;
  Ticks to_;
  bool skipped_ = false;
  std::atomic<bool> stopped_ = false;
  std::future<std::unique_ptr<Match>> prepared_;
  std::unique_ptr<Match> match_;  // null during preparation
  MatchClock clock_;
  ReplayCamera camera_;
};

// The component graph of the vehicle that the player cut last, with the faces removed from it.
class MatchGraph {
 public:
  // Processes the changes of the last tick. Must be called after every tick.
  void follow(const Match& match);
  void clear();

  // Returns the graph, rebuilt at most every kPause seconds of the match while it changes; null before the
  // first cut. Rebuilding is linear in the faces of the body. Precondition: the match is the one followed
  // since clear().
  const std::shared_ptr<const DrawnGraph>& drawn(const Match& match);
  static constexpr double kPause = 0.25;

 private:
  void watch(BodyId body);

  BodyId body_;
  CutFaces removed_;  // from body_, at most the last DrawnGraph::kMost
  bool changed_ = false;
  Ticks made_ = 0;
  std::shared_ptr<const DrawnGraph> drawn_;
};

// Scorch marks of beams on walls and ground; only the latest ones are kept.
class Scorches {
 public:
  static constexpr size_t kMost = 400;

  // Adds a mark at the end of a beam if that is on a wall or the ground.
  void burn(const Match& match, const BeamPicture& beam, const Sight& sight);
  void advance(double seconds);
  void clear() { places_.clear(); }
  void append_to(Effects& effects) const { effects.scorches.assign(places_.begin(), places_.end()); }

 private:
  std::deque<Scorch> places_;
};

// White-hot rings around the cuts where parts came off.
class CutRings {
 public:
  static constexpr double kSeconds = 0.4;

  void add(const Event& event);
  void advance(double seconds);
  void clear() { rings_.clear(); }
  void append_to(Effects& effects) const;

 private:
  struct Ring {
    Vec3 at, across;  // m; unit
    double radius, age;
  };
  std::vector<Ring> rings_;
};

// Selects the graphics preset by frame time: steps down if frames are too slow, directly to the lowest if
// they are far too slow.
class PresetChoice {
 public:
  // `software`: frames are rendered by the processor, fast enough only with the lowest preset.
  explicit PresetChoice(bool software) : best_(software ? PicturePreset::kLow : PicturePreset::kHigh) {}

  // Returns the preset for a setting: the setting itself, except for kAutomatic.
  PicturePreset select(PicturePreset setting) const;
  // Records the duration of the last frame [s].
  void took(double seconds);

 private:
  PicturePreset best_;
  int slow_ = 0, seen_ = 0;  // frames with this preset
};

// Selects the resolution of frames with the lowest preset, as a fraction of that of the window in each
// direction: lowers it if frames take too long, raises it if there is time left.
class ResolutionChoice {
 public:
  static constexpr double kLeast = 0.5, kFirst = 0.7;
  double share() const { return share_; }
  // Records the duration of the last frame [s].
  void took(double seconds);

 private:
  double share_ = kFirst;
  int slow_ = 0, fast_ = 0;  // consecutive frames
};

// Returns true if the current OpenGL context renders without a graphics card.
bool draws_in_software();

// Draws a match: its world at night under floodlights, with the beams of all lasers and their effects.
class MatchPicture {
 public:
  // Fails if a shader is missing or does not compile.
  static Result<MatchPicture> create();

  void show(const Match& match);
  // Follows the changes of the last tick; reloads the match at the beginning of a wave, which brings other
  // vehicles. Must be called after every tick.
  void follow(const Match& match);
  void advance(const Match& match, double seconds);

  // Draws a frame. `preset` is not kAutomatic; with kLow, `share` is that of a ResolutionChoice.
  void draw(const Match& match, const CameraView& view, const Target& target, PicturePreset preset,
            double share = 1);

  // The switches of the debug views.
  ViewOptions& look() { return look_; }
  const Renderer& renderer() const { return renderer_; }

 private:
  explicit MatchPicture(Renderer renderer) : renderer_(std::move(renderer)) {}
  void dress(const Match& match, PicturePreset preset);
  void add_burst(const Vec3& at);

  Renderer renderer_;
  ViewOptions look_;
  Particles particles_;
  Scorches scorches_;
  CutRings rings_;
  MatchGraph graph_;
  std::optional<gl::Framebuffer> small_;  // a frame of a lower resolution
};

// Draws matches as numbered images (frame-00000.png and so on) in a folder, without a window. The OpenGL
// context is current while this exists.
struct MatchFrames {
  gl::OffscreenContext context;
  MatchPicture picture;
  gl::Framebuffer frame;
  std::filesystem::path folder;
  PicturePreset preset = PicturePreset::kHigh;  // kMedium if the memory of OpenGL suffices only for that
  size_t taken = 0;

  // Fails if OpenGL is not available or does not support the size. Precondition: the folder exists.
  static Result<MatchFrames> open(const std::filesystem::path& folder, int width, int height);
  double aspect() const { return static_cast<double>(frame.shape().width) / frame.shape().height; }
  // Draws and writes the next image. Fails if it cannot be written.
  Status take(const Match& match, const CameraView& view);
  // Must be called after the last image: removes those of an earlier, longer film from the folder. Fails if
  // one cannot be removed.
  Status end() const;
};

// A film of a match from behind the player's vehicle.
class MatchFilm {
 public:
  struct Options {
    std::filesystem::path folder;  // exists
    int width = 1280, height = 720;
    double frames_per_second = 30;    // > 0
    std::optional<Vec3> eye, target;  // m; a fixed camera, if both are given
  };

  // Fails like MatchFrames::open.
  static Result<MatchFilm> begin(const Match& match, const Options& options);

  // Must be called after each tick, with the player's controls in it. Writes the images that are due. Fails
  // if one cannot be written.
  Status follow(const Match& match, const Controls& controls);
  // Must be called after the last tick; see MatchFrames::end.
  Status end() const { return frames_.end(); }

 private:
  MatchFilm(MatchFrames frames, const Options& options);

  MatchFrames frames_;
  Options options_;
  GameCamera camera_;
};

}  // namespace kerf
