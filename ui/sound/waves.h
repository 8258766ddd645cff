#pragma once

#include <cstdint>
#include <span>
#include <vector>

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

}  // namespace kerf
