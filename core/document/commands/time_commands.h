#pragma once

#include <string>

#include "core/base/ids.h"
#include "core/base/tick.h"
#include "core/base/vec3.h"

namespace kerf {

class Fields;

// Lets time pass: so many ticks (see core/base/tick.h). It does not end a running stroke; it takes effect
// when the moves before it are executed. All that changes in a world by itself changes here.
struct AdvanceTime {
  Ticks ticks = 0;
  bool bodies = false;  // bodies move (see core/physics), which Play begins
  // Belongs to the step of the history before it whatever that is, and is undone with it. Time that does not
  // is a step of its own after an edit (see Document).
  bool joins = false;

  static constexpr const char* kName = "advance-time";
  // The largest number in one line of a journal: each second of a run is a line of its own.
  static constexpr Ticks kMostInALine = kTicksPerSecond;

  std::string words() const { return bodies ? "Time with moving bodies" : "Time"; }
};
void describe(Fields& f, AdvanceTime& c);

// Holds a piece by a spring, or moves the far end of the spring that holds it (see Spring). It takes effect
// between the ticks before and after it; bodies only follow a spring while they move.
struct DragBody {
  PieceId piece;
  Vec3 at{0};  // m, the point that is held, in the frame of the body
  Vec3 to{0};  // m, in the world, where the spring pulls it

  static constexpr const char* kName = "drag-body";
  std::string words(const std::string& piece_name) const;
};
void describe(Fields& f, DragBody& c);

// Takes the spring away.
struct ReleaseBody {
  static constexpr const char* kName = "release-body";
  std::string words() const { return "Let go"; }
};

// Begins a step of the history in which bodies move: the AdvanceTime commands that follow, up to the next
// stroke or edit, belong to it and are undone with it.
struct Play {
  static constexpr const char* kName = "play";
  std::string words() const { return "Play"; }
};

}  // namespace kerf
