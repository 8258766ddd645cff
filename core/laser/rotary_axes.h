#pragma once

#include <vector>

#include "core/base/geometry.h"

namespace kerf {

// A rotary axis of a machine. Positive angles turn the table or the head by the right-hand rule.
struct RotaryAxis {
  enum class Turns { kTable, kHead };

  char letter = 'A';  // A, B or C
  Turns turns = Turns::kTable;
  Vec3 axis{1, 0, 0};  // unit vector, at zero angles
  // A point of the axis at zero angles [m]: of the machine for a table, and relative to the programmed point
  // for the head.
  Vec3 pivot{0};
};

// The coordinates that a program gives: X, Y and Z in metres, and A, B and C in degrees.
struct MachinePosition {
  Vec3 point{0}, angles{0};
  bool operator==(const MachinePosition&) const = default;
};

// The rotary axes of a machine. Each table carries the next table of the list, and the last one the part;
// each head carries the next head, and the last one the beam. At zero angles the beam points along -Z and
// passes through the programmed point.
struct RotaryAxes {
  std::vector<RotaryAxis> axes;  // each letter at most once
  double height = 0;             // from the programmed point to the start of the beam [m, >= 0]

  // Returns true if the axis of this letter is in the list.
  bool has(char letter) const;
  // Returns the beam in the frame of the part, i.e. of the machine with all tables at zero.
  Pose beam(const MachinePosition& at) const;
  // Returns the number of equal parts into which a move with the laser on must be divided, so that straight
  // moves of the beam from part to part stay within `tolerance` [m, > 0] of it; 1 without rotation.
  double parts(const MachinePosition& from, const MachinePosition& to, double tolerance) const;
};

}  // namespace kerf
