#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>

#include "core/base/ids.h"
#include "core/world/rigid_body.h"
#include "core/world/world.h"
#include "ui/editor/shared/viewport.h"
#include "ui/editor/shared/workspace.h"

namespace kerf {

// Playback state of the open document.
struct PlayState {
  struct Speed {
    double of_real_time = 1;
    const char* name = "1x";
  };
  static constexpr std::array kSpeeds{Speed{0.125, "1/8x"}, Speed{0.25, "1/4x"}, Speed{0.5, "1/2x"},
                                      Speed{1, "1x"}};

  bool playing = false;
  bool one_tick = false;  // a single tick is requested
  size_t speed_index = kSpeeds.size() - 1;

  const Speed& speed() const { return kSpeeds.at(speed_index); }
  bool can_go_slower() const { return speed_index > 0; }
  bool can_go_faster() const { return speed_index + 1 < kSpeeds.size(); }
  void play_or_pause() {
    playing = !playing;
    one_tick = false;
  }
  void request_tick() {
    playing = false;
    one_tick = true;
  }
  void stop() { playing = one_tick = false; }
};

// Measures the actual playback speed, in seconds of the world per second. It is below the selected speed if
// cuts or ticks take longer than real time.
class ReachedSpeed {
 public:
  // Call once per frame with the seconds since the last call; `clock` is that of the world.
  void follow(bool playing, Ticks clock, double seconds);
  // Returns the speed over the last half second; nullopt before the first one is over.
  std::optional<double> of_real_time() const { return reached_; }

 private:
  bool playing_ = false;
  Ticks from_ = 0;      // clock at the start of the measurement
  double seconds_ = 0;  // since then
  std::optional<double> reached_;
};

// Number of ticks that are due, and the limit on ticks queued at once, which adapts to the number that
// previous frames could execute.
struct TickPace {
  double due = 0;   // ticks
  double most = 1;  // max. ticks queued at once

  void slow_down() { most = std::max(1.0, 0.5 * most); }
  void speed_up(double limit) { limit_to(std::min(most + 1, limit)); }
  void limit_to(double ticks) {
    most = ticks;
    due = std::min(due, most);
  }
  void take(Ticks ticks) { due -= std::min(due, static_cast<double>(ticks)); }
};

// Advances time in the open document during playback by queueing ticks in which bodies move.
//
// Ticks are queued only when all previous ones are done, so that the world runs in slow motion if ticks or
// cuts take longer than real time. Undo ends playback. When playback ends, and at each full minute, the
// journal records the state of the bodies, so that opening the journal need not simulate them again.
class TimeFlow {
 public:
  // All arguments must outlive this object. `spring`: the one by which the user pulls a piece.
  TimeFlow(Workspace& workspace, PlayState& play, const std::optional<Spring>& spring)
      : workspace_(workspace), play_(play), spring_(spring) {}

  // Call once per frame after processing the queue, with the seconds since the last frame.
  void advance(double seconds);

 private:
  bool may_continue();
  bool begin();
  void end();
  void queue_spring();
  void queue_ticks(Ticks ticks);

  Workspace& workspace_;
  PlayState& play_;
  const std::optional<Spring>& spring_;
  bool begun_ = false;                   // the document contains Play
  size_t position_ = 0;                  // of the history in the last frame
  std::optional<size_t> before_ground_;  // position before the ground was set, until Play follows
  TickPace pace_;
};

// Cools the open document in real time while playback is off, by queueing ticks in which bodies stand still.
// They belong to the previous history entry, so that one undo covers both.
//
// Like those of TimeFlow, ticks are queued only when all previous ones are done: in each frame while they
// change the viewport, later once per second without a redraw. Time stops while temperatures are frozen, and
// while there are undone history entries, because a tick would discard them.
class Cooling {
 public:
  // Both arguments must outlive this object.
  Cooling(Workspace& workspace, const PlayState& play) : workspace_(workspace), play_(play) {}

  // Call once per frame after processing the queue, with the seconds since the last frame.
  void advance(double seconds);
  // Returns true if a frame is due although nothing else changes.
  bool moving() const;
  // Returns true if only ticks that do not change the viewport are queued.
  bool passes_unseen() const {
    return unseen_ && !workspace_.session.document.queue().pending().holds_beam();
  }
  // Returns true if something cools over time. The renderer reports how long that is visible.
  bool flows() const;

 private:
  bool is_seen() const;

  Workspace& workspace_;
  const PlayState& play_;
  TickPace pace_;
  bool unseen_ = false;
  double passed_at_ = 0;  // time when ticks were last queued [s]
};

// Actions for play and pause, single ticks, speed, gravity and pins. Both arguments must outlive them.
std::vector<UserAction> body_actions(Workspace& workspace, PlayState& play);

// Pins the selected pieces, or releases them. The selection is kept.
void request_pin(Workspace& workspace, bool pinned);

// Returns why no piece can be pinned or released, as a sentence, or null.
const char* pin_disabled_reason(const ViewState& view);
// Returns true if all selected pieces are pinned. Precondition: the pieces are those of the world.
bool selected_are_pinned(const World& world, const ViewState& view);

// Returns the command that switches gravity on or off. Gravity has the Earth's value, and the ground lies
// where it is drawn. Without gravity there is a ground only if +Y points upwards.
SetEnvironment with_gravity(const World& world, const FileFrame& frame, bool on);

// Returns the set speed, with the actual one if that is clearly lower: "1x", "0.12x of 1x".
std::string speed_text(const PlayState& play, const ReachedSpeed& reached);

// Draws the playback state at the upper edge of the first half of the viewport, with speed and elapsed time:
// "Playing 1/2x  3.4 s".
void draw_play_badge(const PlayState& play, const ReachedSpeed& reached, const World& world,
                     const ViewState& view, Badges& badges);

void draw_spring(const Spring& spring, const World& world, const ViewState& view);

}  // namespace kerf
