#pragma once

#include <cstdint>

namespace kerf {

// What the driver of a vehicle does in a tick. Whole numbers, so that a recording holds them exactly.
struct Controls {
  static constexpr int kFull = 100;
  static constexpr double kAimStep = 1e-4;  // rad

  int8_t throttle = 0;  // -kFull .. kFull; against the direction of motion it brakes
  int8_t steer = 0;     // -kFull .. kFull, positive to the left
  bool handbrake = false;
  bool fire = false;
  uint8_t width = 0;               // 0 .. kFull, from the narrowest beam to the widest
  int32_t heading = 0, pitch = 0;  // kAimStep, where in the world the barrel shall point (see direction_of)

  friend bool operator==(const Controls&, const Controls&) = default;
};

}  // namespace kerf
