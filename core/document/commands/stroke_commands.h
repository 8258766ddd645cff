#pragma once

#include <string>

#include "core/base/tick.h"
#include "core/cut/cut_step.h"
#include "core/mesh/files/file_frame.h"

namespace kerf {

class Fields;

// Where the beam of a stroke is, and when.
struct BeamAt {
  Pose pose;
  double time = 0;  // s since the stroke began
};

// Begins a stroke: the beam is on from here, at this pose (world coordinates), at time 0 of the stroke.
struct BeginStroke {
  CutSettings settings;
  Pose pose;

  static constexpr const char* kName = "begin-stroke";
  std::string words(FileUnit unit) const;
};
void describe(Fields& f, BeginStroke& c);

// Moves the beam of the running stroke on, with the beam on all the way.
struct MoveBeam {
  Pose pose;        // world coordinates; the direction is not opposite to the one before
  double time = 0;  // s since the stroke began, not before the pose before; all 0 where times are not known

  static constexpr const char* kName = "move-beam";
  std::string words() const { return "Move the beam"; }
};
void describe(Fields& f, MoveBeam& c);

// Ends the running stroke: the beam is off. A stroke with a smooth rim is smoothed here.
struct EndStroke {
  static constexpr const char* kName = "end-stroke";
  std::string words() const { return "End the stroke"; }
};

// Ends the last stroke earlier than it was drawn: the beam goes off at a place of its path. It is for strokes
// that take long to cut, and belongs to the step of the stroke.
struct StopStroke {
  // The moves of the beam that are cut, of which the first one only switches it on: 12.5 are twelve moves and
  // the first half of the next one, rounded to the parts into which it is subdivided.
  double moves = 0;
  Ticks ticks = 0;  // after those, for which the beam stays on while bodies move

  static constexpr const char* kName = "stop-stroke";
  std::string words() const { return "Stop the stroke"; }
};
void describe(Fields& f, StopStroke& c);

// Takes the last stroke back and cuts it again with other settings.
struct Recut {
  CutSettings settings;

  static constexpr const char* kName = "recut";
  std::string words(FileUnit unit) const;
};
void describe(Fields& f, Recut& c);

}  // namespace kerf
