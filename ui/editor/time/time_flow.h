#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

#include "core/base/tick.h"
#include "core/world/rigid_body.h"
#include "ui/editor/shared/workspace.h"

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

// How fast time passes for the bodies, as it was reached lately: in seconds of the world a second. Where cuts
// or ticks take longer than real time, that is less than the speed that the user has chosen.
class ReachedSpeed {
 public:
  // To be called once a frame; `seconds` have passed since the last call, and `clock` is that of the world.
  void follow(bool playing, Ticks clock, double seconds);
  // Over the last half second; nothing before that is over.
  std::optional<double> of_real_time() const { return reached_; }

 private:
  bool playing_ = false;
  Ticks from_ = 0;      // the clock when the measurement began
  double seconds_ = 0;  // since then
  std::optional<double> reached_;
};

// How many ticks are due, and how many of them are queued at once: that follows from how many the frames
// before could do.
struct TickPace {
  double due = 0;   // ticks
  double most = 1;  // ticks that are queued at once

  void slow_down() { most = std::max(1.0, 0.5 * most); }
  void speed_up(double limit) { limit_to(std::min(most + 1, limit)); }
  void limit_to(double ticks) {
    most = ticks;
    due = std::min(due, most);
  }
  void take(Ticks ticks) { due -= std::min(due, static_cast<double>(ticks)); }
};

// Lets time pass in the open document while the user plays: queues ticks in which bodies move.
//
// Ticks are queued when all before them are done, so that the world goes on in slow motion where ticks or
// cuts take longer than real time. Playing ends when a step of the history is undone. Where it ends, and at
// each full minute, the journal gets a mark of where the bodies are, so that who opens it need not move them
// again.
class TimeFlow {
 public:
  // All must outlive it. `spring` is the one that the user pulls a piece by.
  TimeFlow(Workspace& workspace, PlayState& play, const std::optional<Spring>& spring)
      : workspace_(workspace), play_(play), spring_(spring) {}

  // To be called once a frame after the queue was worked on; `seconds` have passed since the last frame.
  void advance(double seconds);

 private:
  bool may_go_on();
  bool begin();
  void end();
  void queue_spring();
  void queue_ticks(Ticks ticks);

  Workspace& workspace_;
  PlayState& play_;
  const std::optional<Spring>& spring_;
  bool begun_ = false;                   // Play is in the document
  size_t position_ = 0;                  // of the history, in the last frame
  std::optional<size_t> before_ground_;  // the position before the world got its ground, until Play follows
  TickPace pace_;
};

// Lets what is hot in the open document cool down in real time while the user does not play: queues ticks in
// which bodies stand still. They belong to the step of the history before them, so that one undo takes both.
//
// Like the ticks of TimeFlow they are queued when all before them are done. While anything in the picture
// changes by them, they are queued in every frame; after that time passes once a second, and the picture is
// not drawn again. Time waits while heat is held, and while steps of the history are undone: a tick would
// make it impossible to redo them.
class Cooling {
 public:
  // Both must outlive it.
  Cooling(Workspace& workspace, const PlayState& play) : workspace_(workspace), play_(play) {}

  // To be called once a frame after the queue was worked on; `seconds` have passed since the last frame.
  void advance(double seconds);
  // Whether a frame is due although nothing else moves.
  bool moving() const;
  // Whether only ticks wait that change nothing in the picture.
  bool passes_unseen() const { return unseen_ && !workspace_.work.document.execution().beam_waits(); }
  // Whether something hot cools down as time passes. How long that is seen, the renderer tells.
  bool flows() const;

 private:
  bool is_seen() const;

  Workspace& workspace_;
  const PlayState& play_;
  TickPace pace_;
  bool unseen_ = false;
  double passed_at_ = 0;  // s, when ticks were queued last
};

}  // namespace kerf
