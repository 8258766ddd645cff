#pragma once

#include <memory>

#include "core/base/vec3.h"

namespace kerf {

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

}  // namespace kerf
