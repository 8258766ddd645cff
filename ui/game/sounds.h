#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/base/geometry.h"
#include "core/game/match/match.h"

namespace kerf {

// A piece of sound: samples from -1 to 1, 44,100 a second.
using Wave = std::vector<float>;

inline constexpr int kSampleRate = 44'100;

// Sounds of the game, computed from sums of sine waves and filtered noise. Those that are called loops last a
// second and go on without a click when they are repeated. Each call gives the same samples.
Wave engine_loop();           // at idle; played faster it is one at speed
Wave laser_loop();            // the hum of a beam
Wave cutting_loop();          // the crackle where a beam bites
Wave impact_sound();          // a car against something
Wave sheet_sound();           // a piece of sheet metal that falls
Wave explosion_sound();       // a vehicle that goes out of action
Wave chime_sound(bool good);  // a wave that begins, or the end of a match

// The samples of a wave as whole numbers of 16 bits, clamped to their range.
std::vector<int16_t> to_16_bits(std::span<const float> wave);

// Plays the sounds of the game through OpenAL. Where there is no device it is silent and every call does
// nothing.
class Sounds {
 public:
  enum class Loop { kEngine, kLaser, kCutting, kCount };
  enum class Shot { kImpact, kSheet, kExplosion, kGoodChime, kBadChime, kCount };

  Sounds();
  ~Sounds();
  Sounds(const Sounds&) = delete;
  Sounds& operator=(const Sounds&) = delete;

  // Whether there is a device.
  bool on() const { return device_ != nullptr; }

  // Sets the volume of all sounds, 0 .. 1.
  void set_volume(double volume);
  // Where the ears are (world, m), and which way they look (unit).
  void listen(const Vec3& at, const Vec3& forward);
  // A loop that comes from a place, one for each `voice` (0 .. kVoices - 1); silent at a gain of 0. A pitch
  // (> 0) of 2 plays it twice as fast.
  static constexpr size_t kVoices = 6;
  void set(Loop loop, size_t voice, const Vec3& at, double gain, double pitch = 1);
  // Plays a sound once at a place.
  void play(Shot shot, const Vec3& at, double gain, double pitch = 1);
  // Stops everything, e.g. while the game is paused.
  void hush();

 private:
  struct Device;
  std::unique_ptr<Device> device_;
};

// The sounds of a match, heard from the camera.
class MatchSounds {
 public:
  // Takes the events of the last tick.
  void hear(const Match& match);
  // Sets engines and lasers. `volume` of all, 0 .. 1.
  void advance(const Match& match, const Vec3& eye, const Vec3& forward, double volume);
  void hush() { sounds_.hush(); }

 private:
  Sounds sounds_;
  double cutting_[Sounds::kVoices] = {};  // the gain of each voice
};

}  // namespace kerf
