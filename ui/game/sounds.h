#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/base/geometry.h"
#include "core/game/match/match.h"

namespace kerf {

// Sound samples from -1 to 1, at 44,100 Hz.
using Wave = std::vector<float>;

inline constexpr int kSampleRate = 44'100;

// Sounds of the game, synthesised from sine waves and filtered noise. Loops last a second and repeat
// without a click. Deterministic.
Wave engine_loop();           // at idle; played faster, at speed
Wave laser_loop();            // hum of a beam
Wave cutting_loop();          // crackle of cutting
Wave warning_loop();          // whine of a laser before its first beam
Wave impact_sound();          // crash of a car
Wave sheet_sound();           // falling piece of sheet metal
Wave explosion_sound();       // destruction of a vehicle
Wave chime_sound(bool good);  // beginning of a wave, or end of a match

// The gain of cutting_loop() at a time [s] after it was `gain`, without a cut in between.
double faded_cutting_gain(double gain, double seconds);

// Converts a wave to 16-bit integers, clamped to their range.
std::vector<int16_t> to_16_bits(std::span<const float> wave);

// Plays the sounds of the game through OpenAL. Without a device it is silent and every call is a no-op.
class Sounds {
 public:
  enum class Loop { kEngine, kLaser, kCutting, kWarning, kCount };
  enum class Shot { kImpact, kSheet, kExplosion, kGoodChime, kBadChime, kCount };

  Sounds();
  ~Sounds();
  Sounds(const Sounds&) = delete;
  Sounds& operator=(const Sounds&) = delete;

  bool on() const { return device_ != nullptr; }

  void set_volume(double volume);  // of all sounds, 0 .. 1
  // Sets the position of the listener (world, m) and its direction (unit).
  void listen(const Vec3& at, const Vec3& forward);
  // Sets a loop at a place, one for each `voice` (0 .. kVoices - 1); silent at a gain of 0. A pitch (> 0)
  // of 2 doubles the speed. Each vehicle of a match has a voice.
  static constexpr size_t kVoices = 1 + kMaxEnemies;
  static_assert(Match::kMaxOthers <= kMaxEnemies);
  void set(Loop loop, size_t voice, const Vec3& at, double gain, double pitch = 1);
  void play(Shot shot, const Vec3& at, double gain, double pitch = 1);
  // Silences all loops, e.g. while the game is paused. The other sounds end by themselves within 1.4 s.
  void hush();

 private:
  struct Device;
  std::unique_ptr<Device> device_;
};

// The sounds of a match at the camera.
class MatchSounds {
 public:
  void on_tick(const Match& match);
  // Updates engines and lasers after a time [s]. `volume` of all, 0 .. 1.
  void advance(const Match& match, const Vec3& eye, const Vec3& forward, double volume, double seconds);
  void hush() { sounds_.hush(); }

 private:
  Sounds sounds_;
  double cutting_[Sounds::kVoices] = {};  // gain of each voice
};

}  // namespace kerf
