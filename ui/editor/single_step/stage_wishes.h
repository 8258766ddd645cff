#pragma once

#include <cstddef>
#include <limits>
#include <optional>

namespace kerf {

// What the user asks for in single steps.
struct StageWishes {
  static constexpr double kSlowest = 0.5, kFastest = 60;
  static constexpr size_t kAll = std::numeric_limits<size_t>::max();

  bool on = false;              // the last stroke is executed in single steps
  double per_second = 4;        // stages, while playing
  bool playing = false;         // stages are executed one after the other
  bool start_again = false;     // the last stroke is taken back, to be executed again
  bool to_end_of_move = false;  // stages are executed until a move of the beam is finished
  std::optional<size_t> stage;  // the number of stages of the stroke that are to be executed; kAll: all

  void stop() {
    playing = to_end_of_move = false;
    stage.reset();
  }
  void go_to(size_t stages) {
    stop();
    stage = stages;
  }
  void run_to_end_of_move() {
    stop();
    to_end_of_move = true;
  }
  void begin_again() {
    stop();
    on = start_again = true;
  }
};

}  // namespace kerf
