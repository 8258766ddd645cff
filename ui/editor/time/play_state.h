#pragma once

#include <array>
#include <cstddef>

namespace kerf {

// Whether time passes for the bodies of the open document, and how fast.
struct PlayState {
  struct Speed {
    double of_real_time = 1;
    const char* name = "1x";
  };
  static constexpr std::array kSpeeds{Speed{0.125, "1/8x"}, Speed{0.25, "1/4x"}, Speed{0.5, "1/2x"},
                                      Speed{1, "1x"}};

  bool playing = false;
  bool one_tick = false;  // a single tick is asked for
  size_t speed_index = kSpeeds.size() - 1;

  const Speed& speed() const { return kSpeeds.at(speed_index); }
  bool can_go_slower() const { return speed_index > 0; }
  bool can_go_faster() const { return speed_index + 1 < kSpeeds.size(); }
  void play_or_pause() {
    playing = !playing;
    one_tick = false;
  }
  void ask_for_tick() {
    playing = false;
    one_tick = true;
  }
  void stop() { playing = one_tick = false; }
};

}  // namespace kerf
